#include "app/panels/size_panel.h"

#include <QFileInfo>
#include <QListWidget>
#include <QLocale>
#include <QMenu>
#include <QToolButton>

#include "app/panels/fields/number_boxes.h"
#include "app/panels/fields/panel_parts.h"
#include "app/panels/fields/reasons.h"
#include "app/panels/fields/region_numbers.h"
#include "app/project/design.h"
#include "app/project/domain.h"
#include "app/project/edits/size_edits.h"
#include "app/project/options/options.h"

namespace wend {

namespace {

constexpr double kReach = 0.15;  // of a new region, relative to the diagonal

QString factorText(double factor) {
    return QStringLiteral("×") + QLocale().toString(factor, 'g', 3);
}

}  // namespace

SizePanel::SizePanel(ShapeSession& session, Brush& brush, QWidget* parent)
    : QWidget(parent),
      m_session(session),
      m_brush(brush),
      m_factor(new MagnitudeBox(this)),
      m_list(new QListWidget(this)),
      m_add(new QToolButton(this)),
      m_remove(new QToolButton(this)),
      m_shape(new QWidget(this)),
      m_numbers(new RegionNumbers(RegionNumbers::Radius::Here, m_shape)),
      m_feather(new MagnitudeBox(m_shape)),
      m_note(secondLabel({}, this)) {
    makeControls();
    makeAddMenu();
    arrange();
    connectControls();
    showSizes();
}

void SizePanel::makeControls() {
    const Range range = option("domain.sizes[].factor").range;
    m_factor->setRange(range.min, range.max);
    m_factor->setPrefix(QStringLiteral("×"));
    m_factor->setObjectName(QStringLiteral("sizeFactor"));
    describe(m_factor, tr("Length of edges"),
             tr("How long edges are there, compared with elsewhere: 0.5 is half as long, which is finer; 2 "
                "is twice as long, which is coarser."));
    m_list->setFixedHeight(96);
    m_list->setObjectName(QStringLiteral("sizeList"));
    describe(m_list, tr("Where cells are finer or coarser"),
             tr("What the next stroke does, and the strokes and regions so far; where two overlap, the lower "
                "one counts. A click shows the numbers, which can be changed."));
    m_add->setText(tr("Add"));
    m_add->setPopupMode(QToolButton::InstantPopup);
    m_remove->setText(tr("Remove"));
    for (QToolButton* button : {m_add, m_remove}) button->setProperty("role", "chip");
    describe(m_add, tr("Add region"),
             tr("A ball, a box or a half-space in the middle, or what the selected handle holds as a region; "
                "its numbers can then be changed."));
    describe(m_remove, tr("Remove sizes"), tr("Removes the chosen stroke or region."));
    m_feather->setRange(0, 1e9);
    m_feather->setObjectName(QStringLiteral("sizeFeather"));
    describe(m_feather, tr("Soft edge"),
             tr("Over what width the size blends into that around it, in the file's units."));
}

void SizePanel::makeAddMenu() {
    auto* menu = new QMenu(m_add);
    const auto reach = [this] { return kReach * m_session.frame()->diagonal; };
    const auto entry = [&](const QString& text, auto act) {
        return menu->addAction(text, this, [this, act] {
            if (m_session.frame<3>()) act();
        });
    };
    entry(tr("Ball"), [=, this] { add(Ball<3>{middle(), reach()}); });
    entry(tr("Box"), [=, this] { add(Box<3>{middle().array() - reach(), middle().array() + reach()}); });
    entry(tr("Half-space"), [=, this] { add(HalfSpace<3>{middle(), Vec<3>::UnitX()}); });
    m_selected = entry(tr("Region of the selected handle"), [this] { addSelected(); });
    menu->setToolTipsVisible(true);
    m_add->setMenu(menu);
}

void SizePanel::arrange() {
    auto* layout = sectionColumn(this);
    layout->addWidget(panelTitle(tr("Cell sizes"), this));
    layout->addLayout(panelRow(tr("E&dges"), m_factor, this));
    layout->addWidget(m_list);
    layout->addLayout(sideBySide({m_add, nullptr, m_remove}));
    auto* shape = bareColumn(m_shape, 10);
    shape->addWidget(m_numbers);
    shape->addLayout(panelRow(tr("Soft ed&ge"), m_feather, m_shape));
    layout->addWidget(m_shape);
    layout->addWidget(m_note);
}

void SizePanel::connectControls() {
    connect(m_factor, &QDoubleSpinBox::valueChanged, this, &SizePanel::changeFactor);
    connect(m_list, &QListWidget::currentRowChanged, this, &SizePanel::showGroup);
    connect(m_numbers, &RegionNumbers::changed, this,
            [this](const Region<3>& shape) { changeShape(shape, m_feather->value()); });
    connect(m_feather, &QDoubleSpinBox::valueChanged, this, [this](double feather) {
        if (group() >= 0)
            changeShape(sizeGroups(m_session.document().domain())[group()].first.shape, feather);
    });
    connect(m_remove, &QToolButton::clicked, this, [this] {
        Document& document = m_session.document();
        if (group() >= 0) document.changeDomain(tr("Remove sizes"), withoutSizes(document.domain(), group()));
    });
    connect(&m_session.document(), &Document::projectChanged, this, &SizePanel::showSizes);
    connect(&m_brush.edges(), &PenValue::changed, this, &SizePanel::showGroup);
    connect(&m_session, &ShapeSession::pinsChanged, this, [this] {
        const auto& selected = m_session.selection().handles();
        const bool solid = m_session.document().dimension() == 3 && selected.size() == 1;
        const auto count = solid ? m_session.document().design().handles.size() : 0;
        allowSelected(
            solid && selected.front() < static_cast<int>(count) &&
            std::holds_alternative<Region<3>>(m_session.document().design().handles[selected.front()].at));
    });
    allowSelected(false);
}

void SizePanel::allowSelected(bool allowed) {
    allow(m_selected, allowed, tr("First select a pin that holds a ball, a box or one side."));
}

/// Returns the position in sizeGroups(); −1 for the next stroke.
int SizePanel::group() const {
    return m_list->currentRow() - 1;
}

Vec<3> SizePanel::middle() const {
    const Points<3>& rest = m_session.frame<3>()->rest->points;
    return (rest.rowwise().minCoeff() + rest.rowwise().maxCoeff()) / 2;
}

void SizePanel::changeFactor(double factor) {
    if (group() < 0) return m_brush.edges().set(factor);
    Document& document = m_session.document();
    document.changeDomain(tr("Change size"), withSizeFactor(document.domain(), group(), factor),
                          QStringLiteral("size factor %1").arg(group()));
}

/// Changes the shape of the group. Consecutive numbers merge into one undo step.
void SizePanel::changeShape(const Region<3>& shape, double feather) {
    if (group() < 0) return;
    Document& document = m_session.document();
    document.changeDomain(tr("Change region"), withSizeShape(document.domain(), group(), shape, feather),
                          QStringLiteral("size region %1").arg(group()));
}

void SizePanel::add(const Region<3>& shape) {
    Document& document = m_session.document();
    document.changeDomain(tr("Add size region"),
                          withSizeRegion(document.domain(), shape, m_brush.edges().now()));
    m_list->setCurrentRow(m_list->count() - 1);
}

void SizePanel::addSelected() {
    const auto& at = m_session.document().design().handles[m_session.selection().handles().front()].at;
    if (const auto* region = std::get_if<Region<3>>(&at)) add(*region);
}

QString SizePanel::textOf(const SizeGroup& group) const {
    const Region<3>& shape = group.first.shape;
    const QString kind = std::holds_alternative<Ball<3>>(shape)        ? tr("Ball")
                         : std::holds_alternative<Box<3>>(shape)       ? tr("Box")
                         : std::holds_alternative<HalfSpace<3>>(shape) ? tr("Half-space")
                                                                       : tr("Blend");
    const QString name = group.name.empty() ? kind : QString::fromStdString(group.name);
    return tr("%1: edges %2").arg(name, factorText(group.first.factor));
}

void SizePanel::showSizes() {
    if (m_session.document().dimension() != 3) return;
    const Domain& domain = m_session.document().domain();
    const int chosen = m_list->currentRow();
    {
        const QSignalBlocker quiet(m_list);
        m_list->clear();
        m_list->addItem(tr("Next stroke"));
        for (const SizeGroup& group : sizeGroups(domain)) m_list->addItem(textOf(group));
        m_list->setCurrentRow(chosen >= 0 && chosen < m_list->count() ? chosen : 0);
    }
    QStringList notes;
    if (!domain.sizesFile.empty())
        notes << tr("Beneath them: the factors in %1.")
                     .arg(QFileInfo(QString::fromStdString(domain.sizesFile)).fileName());
    if (!domain.refineSurface)
        notes << tr(
            "The surface's triangles are kept, and only the inside changes. “Refine surface” in the panel "
            "“Mesh” allows them to be split, too.");
    m_note->setText(notes.join(QLatin1Char('\n')));
    m_note->setVisible(!notes.isEmpty());
    showGroup();
}

void SizePanel::showGroup() {
    if (m_session.document().dimension() != 3) return;
    const auto groups = sizeGroups(m_session.document().domain());
    const bool has = group() >= 0 && group() < static_cast<int>(groups.size());
    const QSignalBlocker a(m_factor), b(m_feather);
    m_factor->setValue(has ? groups[group()].first.factor : m_brush.edges().now());
    allow(m_remove, has, chooseFirst());
    const bool one =
        has && groups[group()].entries.size() == 1 && RegionNumbers::canShow(groups[group()].first.shape);
    m_shape->setVisible(one);
    const double diagonal = m_session.frame() ? m_session.frame()->diagonal : 1;
    if (one) m_numbers->showRegion(groups[group()].first.shape, diagonal);
    if (one) m_feather->setValue(groups[group()].first.feather);
    std::vector<Region<3>> regions;
    if (has)
        for (const int i : groups[group()].entries)
            regions.push_back(m_session.document().domain().sizes[i].shape);
    m_brush.regions().set(regions);
}

}  // namespace wend
