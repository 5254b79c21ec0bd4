#include "app/window/export/export_panel.h"

#include <QAction>
#include <QButtonGroup>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

#include "app/base/connect_each.h"
#include "app/panels/fields/controls.h"
#include "app/panels/fields/panel_parts.h"
#include "app/session/shape_motion.h"
#include "app/window/actions/actions.h"
#include "app/window/export/dialogs.h"
#include "app/window/export/exporter.h"

namespace wend {

namespace {

constexpr int kSoon = 120;  // milliseconds: a moving shape is previewed once it rests

}  // namespace

QString ExportDialog::title(ExportKind kind) {
    switch (kind) {
        case ExportKind::Picture:
            return tr("Export Picture");
        case ExportKind::Film:
            return tr("Export Film");
        case ExportKind::Frames:
            return tr("Export Sequence");
        case ExportKind::StMap:
            return tr("Export ST Map");
        case ExportKind::Mesh:
            break;
    }
    return tr("Export Mesh");
}

ExportDialog::ExportDialog(const ExportSubject& subject, ExportChoices& choices, QWidget* parent)
    : QDialog(parent), m_form(new ExportForm(ExportForm::Fields::Beside, choices, this)) {
    setWindowTitle(title(subject.kind));
    QDialogButtonBox* buttons = dialogButtons(QDialogButtonBox::Cancel, this);
    QPushButton* write = addExportButton(*buttons);
    connect(m_form, &ExportForm::readyChanged, write, &QWidget::setEnabled);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(16, 16, 16, 16);
    column->setSpacing(12);
    column->addWidget(m_form, 1);
    column->addWidget(buttons);
    m_form->setSubject(subject);
}

ExportPanel::ExportPanel(const ShapeMotion& motion, Exporter& exporter, const Actions& actions,
                         QWidget* parent)
    : QWidget(parent),
      m_motion(motion),
      m_exporter(exporter),
      m_kinds(new QButtonGroup(this)),
      m_form(new ExportForm(ExportForm::Fields::Below, exporter.choices(), this)),
      m_write(pushButton(
          this, "", tr("Export…"), tr("Choose a name and write what the preview shows."),
          [this] { m_exporter.writeAs(*m_form); }, tr("Export"))),
      m_view(viewButton(actions.exportView)),
      m_film(viewButton(actions.exportFilm)) {
    addKind(ExportKind::Picture, tr("Picture"), actions.exportPicture);
    addKind(ExportKind::StMap, tr("ST Map"), actions.exportStMap);
    addKind(ExportKind::Mesh, tr("Mesh"), actions.exportMesh);
    addKind(ExportKind::Film, tr("Film"), actions.exportFilm);
    addKind(ExportKind::Frames, tr("Sequence"), actions.exportFrames);
    // In one row they would be wider than the panel in some languages.
    auto* kinds = new QVBoxLayout;
    auto *still = new QHBoxLayout, *moving = new QHBoxLayout;
    for (QBoxLayout* one :
         {static_cast<QBoxLayout*>(kinds), static_cast<QBoxLayout*>(still), static_cast<QBoxLayout*>(moving)})
        one->setSpacing(0);
    kinds->addLayout(still);
    kinds->addLayout(moving);
    for (QAbstractButton* button : m_kinds->buttons())
        (isMotion(static_cast<ExportKind>(m_kinds->id(button))) ? moving : still)->addWidget(button);
    m_write->setProperty("role", "primary");
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(16, 12, 16, 12);
    column->setSpacing(8);
    column->addWidget(panelTitle(tr("Export"), this));
    column->addLayout(kinds);
    column->addWidget(m_form, 1);
    column->addWidget(m_write);
    column->addWidget(m_view);
    column->addWidget(m_film);
    m_soon.setSingleShot(true);
    m_soon.setInterval(kSoon);
    connectEach(this, &ExportPanel::showShape, &m_soon, &QTimer::timeout, m_kinds, &QButtonGroup::idClicked);
    connect(&m_motion.document(), &Document::opened, m_form, &ExportForm::takeChoices);
    connect(m_form, &ExportForm::readyChanged, m_write, &QWidget::setEnabled);
    connectEach(this, &ExportPanel::ask, &m_exporter.crop(), &Crop::changed, &m_exporter,
                &Exporter::viewTurned, &m_motion, &ShapeMotion::frameChanged, &m_motion,
                &ShapeMotion::busyChanged, &m_motion, &ShapeMotion::problem);
}

void ExportPanel::addKind(ExportKind kind, const QString& name, QAction* action) {
    auto* button = new QToolButton(this);
    button->setText(name);
    button->setCheckable(true);
    button->setProperty("role", "segment");
    button->setProperty("long", true);  // three in a narrow panel
    button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    m_kinds->addButton(button, static_cast<int>(kind));
    m_actions[static_cast<int>(kind)] = action;
    connect(action, &QAction::changed, this, &ExportPanel::ask);
}

QPushButton* ExportPanel::viewButton(QAction* action) {
    return pushButton(this, "", withoutKey(action->text()), action->statusTip(),
                      [action] { action->trigger(); });
}

ExportKind ExportPanel::kind() const {
    return static_cast<ExportKind>(m_kinds->checkedId());
}

void ExportPanel::ask() {
    if (isVisible()) m_soon.start();
}

void ExportPanel::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    showShape();
}

/// Updates the kinds, and selects the last one chosen or, if it is not available, the first that is.
void ExportPanel::showShape() {
    const bool solid = m_motion.document().dimension() == 3;
    QAbstractButton *first = nullptr, *chosen = m_kinds->checkedButton();
    for (QAbstractButton* button : m_kinds->buttons()) {
        const QAction* action = m_actions[m_kinds->id(button)];
        const auto kind = static_cast<ExportKind>(m_kinds->id(button));
        const bool flatOnly = kind != ExportKind::Frames && kind != ExportKind::Mesh;
        button->setVisible(!solid || !flatOnly);
        button->setEnabled(action->isEnabled());
        describe(button, button->text(), action->statusTip());
        if (!action->isEnabled()) button->setToolTip(action->toolTip());
        if (!first && button->isVisibleTo(this) && action->isEnabled()) first = button;
    }
    if (first && (!chosen || !chosen->isEnabled() || !chosen->isVisibleTo(this))) first->setChecked(true);
    for (QPushButton* button : {m_view, m_film}) button->setVisible(solid);
    const QString why = m_exporter.whyNot();
    why.isEmpty() ? m_form->setSubject(m_exporter.subject(kind())) : m_form->setNothing(why);
}

}  // namespace wend
