#include "app/panels/surface_panel.h"

#include <QEvent>
#include <QLabel>
#include <algorithm>

#include "app/panels/fields/controls.h"
#include "app/panels/fields/option_field.h"
#include "app/panels/fields/panel_parts.h"
#include "app/panels/fields/reasons.h"

namespace wend {

SurfacePanel::SurfacePanel(QWidget* parent)
    : QWidget(parent),
      m_title(panelTitle({}, this)),
      m_text(secondLabel({}, this)),
      m_case(secondLabel({}, this)),
      m_fixText(secondLabel({}, this)) {
    makeSteps();
    makeFixes();
    makeRepair();
    m_case->setAlignment(Qt::AlignCenter);
    m_fixText->setMinimumHeight(3 * fontMetrics().lineSpacing());  // buttons below stay where they are
    arrange();
}

void SurfacePanel::arrange() {
    auto* layout = sectionColumn(this);
    m_title->setWordWrap(true);
    layout->addWidget(m_title);
    layout->addWidget(m_kind);
    auto* steps = new QHBoxLayout;
    for (QWidget* widget : std::initializer_list<QWidget*>{m_previous, m_case, m_next})
        steps->addWidget(widget, widget == m_case);
    layout->addLayout(steps);
    layout->addWidget(m_fixText);
    layout->addLayout(sideBySide({m_fix, m_fixAll}));
    layout->addWidget(m_text);
    layout->addLayout(sideBySide({m_show, m_save}));
    m_hole->setWidth(kControlWidth, 80);
    layout->addWidget(panelRowIn(m_hole->label(), m_hole, this));
    layout->addWidget(m_fillUp);
    layout->addLayout(sideBySide({m_preview, m_repair}));
    layout->addWidget(m_fit);
}

/// Makes the choice of a kind of faults, and the steps through those of this kind.
void SurfacePanel::makeSteps() {
    m_kind = choiceBox(this, "", tr("What is wrong"), tr("The kinds of faults, and how often each occurs."),
                       {}, [this] {
                           m_number = 0;
                           step(0);
                       });
    m_previous = buttonFor<QToolButton>(
        this, "", {}, tr("Goes to the previous place where this is wrong."), [this] { step(-1); },
        tr("Previous place"));
    m_previous->setArrowType(Qt::LeftArrow);
    m_next = buttonFor<QToolButton>(
        this, "", {}, tr("Goes to the next place where this is wrong."), [this] { step(1); },
        tr("Next place"));
    m_next->setArrowType(Qt::RightArrow);
}

void SurfacePanel::makeFixes() {
    m_fix = pushButton(this, "", tr("Fix this one"),
                       tr("Fixes only what is shown: what it adds is green, what it takes away or turns is "
                          "yellow."),
                       &SurfacePanel::fixRequested);
    m_fixAll = pushButton(this, "", tr("Fix all"), {}, &SurfacePanel::fixAllRequested);
    m_fixAll->installEventFilter(this);
    m_show = pushButton(
        this, "", tr("Show them"),
        tr("Colours the triangles that are wrong and shows them: what hides them is left out."),
        [this](bool on) {
            m_preview->setChecked(false);
            if (on)
                step(0);
            else
                emit solidWanted();
        },
        tr("Show the triangles"));
    m_show->setCheckable(true);
    m_save = pushButton(this, "", tr("Save list…"),
                        tr("Writes the numbers of all wrong triangles and edges to a file."),
                        &SurfacePanel::saveRequested, tr("Save the list"));
}

void SurfacePanel::makeRepair() {
    m_hole = new OptionField("domain.repair.largestHole", this);
    connect(m_hole, &OptionField::changed, this, [this] { emit limitChanged(largestHole()); });
    m_fillUp = pushButton(this, "fillUp", {}, {}, [this] {
        m_hole->setNumber(m_edges);
        emit limitChanged(largestHole());
    });
    m_preview = pushButton(this, "", tr("See the repair"),
                           tr("Shows the surface as the repair would leave it: what it adds in green, what "
                              "stays wrong in red."),
                           [this](bool on) {
                               m_show->setChecked(!on && !m_contents.isCaged);
                               emit repairShown(on);
                           });
    m_preview->setCheckable(true);
    m_repair = pushButton(this, "", tr("Repair"),
                          tr("Merges coincident points, drops degenerate and duplicate triangles, orients "
                             "the others and fills small holes."),
                          [this] { emit repairRequested(largestHole()); });
    m_fit = pushButton(this, "", {}, {}, [this] { emit fitRequested(!m_contents.isCaged); });
}

bool SurfacePanel::eventFilter(QObject* watched, QEvent* event) {
    const bool comes = event->type() == QEvent::Enter || event->type() == QEvent::FocusIn;
    const bool goes = event->type() == QEvent::Leave || event->type() == QEvent::FocusOut;
    if (comes || goes) emit fixOfAllShown(comes && m_fixAll->isEnabled());
    return QWidget::eventFilter(watched, event);
}

void SurfacePanel::step(int by) {
    const int kind = m_kind->currentIndex();
    if (kind < 0) return;
    const int count = m_contents.kinds[kind].count;
    m_number = (m_number + by + count) % count;
    m_show->setChecked(true);
    m_preview->setChecked(false);
    tellCase();
    emit caseChosen(kind, m_number);
}

void SurfacePanel::tellCase() {
    const int kind = m_kind->currentIndex();
    m_case->setText(kind < 0 ? QString()
                             : tr("%1 of %2").arg(m_number + 1).arg(m_contents.kinds[kind].count));
}

void SurfacePanel::showProblems(const Contents& contents) {
    m_contents = contents;
    m_number = contents.number;
    m_title->setText(contents.isCaged ? tr("The surface is embedded in a cage")
                                      : tr("The surface bounds no solid"));
    m_kind->clear();
    for (const Kind& kind : contents.kinds) m_kind->addItem(tr("%1: %2").arg(kind.name).arg(kind.count));
    m_kind->setCurrentIndex(contents.kinds.empty() ? -1 : contents.kind);
    const bool any = !contents.kinds.empty();
    for (QWidget* widget : std::initializer_list<QWidget*>{m_kind, m_previous, m_next, m_case, m_show})
        widget->setEnabled(any);
    for (QWidget* widget : std::initializer_list<QWidget*>{m_fixText, m_fix, m_fixAll})
        widget->setVisible(any);
    tellCase();
    m_show->setChecked(!contents.isCaged);
    m_hole->setNumber(contents.largestHole);
    m_preview->setChecked(false);
    m_fit->setText(contents.isCaged ? tr("Exact surface only") : tr("Fit a cage"));
    describe(m_fit, m_fit->text(),
             contents.isCaged
                 ? tr("Removes the cage: without a repair there is then no solid.")
                 : tr("Fills a cage of even cells around the surface, which is embedded in it."));
    emit faultsShown(contents.isCaged);
}

void SurfacePanel::tellOfRepair(bool helps, const QString& repair) {
    m_text->setText((m_contents.more + QStringList{verdict(helps), repair}).join('\n').trimmed());
    allow(m_preview, !repair.isEmpty(), tr("There is nothing that the simple repairs would change."));
    allow(m_repair, helps, verdict(false));
    if (!m_preview->isChecked()) return;
    m_preview->setChecked(!repair.isEmpty());
    emit repairShown(m_preview->isChecked());
}

/// Disables the button if no larger hole is left, and never hides it.
void SurfacePanel::tellOfHoles(const std::vector<int>& edges) {
    m_edges = edges.empty() ? 0 : *std::ranges::max_element(edges);
    const QString found =
        edges.size() == 1 ? tr("One hole has %1 edges: fill up to %1").arg(m_edges)
                          : tr("%1 holes have up to %2 edges: fill up to %2").arg(edges.size()).arg(m_edges);
    m_fillUp->setText(m_edges > largestHole() ? found : tr("No hole is larger"));
    describe(m_fillUp, m_fillUp->text(), tr("Sets the largest hole that the repair fills to this."));
    offer(m_fillUp, m_edges > largestHole());
}

QString SurfacePanel::verdict(bool helps) const {
    if (helps) return tr("“Repair” helps.");
    return m_contents.isCaged ? tr("“Repair” does not help: the cage carries the surface as it is.")
                              : tr("“Repair” does not help: a cage around it can carry it.");
}

int SurfacePanel::largestHole() const {
    return static_cast<int>(m_hole->number());
}

void SurfacePanel::showFix(const QString& text, bool mayFix) {
    m_fixText->setText(text);
    if (isVisible())
        m_fixText->setMinimumHeight(
            std::max(m_fixText->minimumHeight(), m_fixText->heightForWidth(m_fixText->width())));
    offer(m_fix, mayFix);
}

/// Moves focus off a button that gets disabled, so that a second Enter cannot remove the cage.
void SurfacePanel::offer(QPushButton* button, bool offered) {
    if (!offered && button->hasFocus()) m_next->setFocus();
    button->setEnabled(offered);
}

/// Shows the effect in the help text, because it may arrive late and must not move anything.
void SurfacePanel::showFixOfAll(const QString& text, bool mayFix) {
    const QString help =
        tr("Fixes all of this kind that simple steps can, as one step of undo; of the holes, those with no "
           "more edges than chosen below.");
    describe(m_fixAll, m_fixAll->text(), text.isEmpty() ? help : text + ' ' + help);
    const int kind = m_kind->currentIndex();
    offer(m_fixAll, mayFix && kind >= 0 && m_contents.kinds[kind].count > 1);
}

bool SurfacePanel::leave() {
    const bool looks = m_show->isChecked() || m_preview->isChecked();
    for (QPushButton* button : {m_show, m_preview}) button->setChecked(false);
    return looks;
}

}  // namespace wend
