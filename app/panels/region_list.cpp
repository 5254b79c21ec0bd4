#include "app/panels/region_list.h"

#include <QFileInfo>
#include <QItemDelegate>
#include <QListWidget>
#include <QLocale>
#include <QMenu>
#include <QPainter>

#include "app/panels/fields/controls.h"
#include "app/panels/fields/panel_parts.h"
#include "app/panels/fields/reasons.h"
#include "app/panels/fields/region_numbers.h"
#include "app/panels/list_items.h"
#include "app/project/domain.h"
#include "app/project/edits/handle_edits.h"
#include "app/project/edits/layer_edits.h"
#include "app/project/edits/value_edits.h"
#include "app/project/options/options.h"

namespace wend {

namespace {

constexpr int kValue = Qt::UserRole;  // of an item, in words
constexpr double kPercent = 100;
constexpr double kReach = 0.15;  // of a new region, relative to the diagonal

/// A name at the left, which can be changed, and a value at the right.
class ValueDelegate : public QItemDelegate {
  public:
    using QItemDelegate::QItemDelegate;
    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override {
        QItemDelegate::paint(painter, option, index);
        const bool selected = option.state & QStyle::State_Selected;
        painter->setPen(
            option.palette.color(selected ? QPalette::HighlightedText : QPalette::PlaceholderText));
        painter->drawText(option.rect.adjusted(0, 0, -8, 0), Qt::AlignRight | Qt::AlignVCenter,
                          index.data(kValue).toString());
    }
};

}  // namespace

RegionList::RegionList(Document& document, Selection& selection, ShapeMotion& motion, Brush& brush,
                       RegionsOf of, QWidget* parent)
    : QWidget(parent),
      m_document(document),
      m_selection(selection),
      m_motion(motion),
      m_brush(brush),
      m_of(of),
      m_none(secondLabel(
          isDetail() ? tr("The mesh is equally fine everywhere: brush over what should be finer or coarser.")
                     : tr("Nothing has an order of its own: brush over what should lie in front or behind."),
          this)),
      m_list(new QListWidget(this)),
      m_shape(new QWidget(this)),
      m_note(secondLabel({}, this)) {
    makeList();
    makeControls();
    makeAddMenu();
    arrange();
    connect(&m_document, &Document::projectChanged, this, &RegionList::showLayers);
    connect(&m_selection, &Selection::changed, this, &RegionList::allowSelected);
    showLayers();
}

void RegionList::makeList() {
    m_list->setObjectName(isDetail() ? QStringLiteral("detailRegions") : QStringLiteral("depthRegions"));
    m_list->setFixedHeight(96);
    m_list->setItemDelegate(new ValueDelegate(m_list));
    m_list->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
    describe(m_list, isDetail() ? tr("Where the mesh is finer or coarser") : tr("What lies in front"),
             tr("The strokes and regions so far; where two overlap, the upper one counts. A click shows "
                "where it lies and its number, a double-click changes its name."));
    connect(m_list, &QListWidget::currentRowChanged, this, &RegionList::showChosen);
    connect(m_list, &QListWidget::itemChanged, this, &RegionList::rename);
}

void RegionList::makeControls() {
    const Range range = option(isDetail() ? "domain.sizes[].factor" : "depth[].order").range;
    const auto change = [this] {
        const double value = m_value->exact() / (isDetail() ? kPercent : 1);
        this->change(isDetail() ? tr("Change edges") : tr("Change order"),
                     withLayer(layers(), chosenId(), [&](ValueLayer& layer) { layer.value = value; }),
                     QStringLiteral("layer value %1").arg(qulonglong(chosenId())));
    };
    m_value = isDetail()
                  ? numberBox(this, "detailValue", tr("Length of edges"),
                              tr("How long edges are there, compared with elsewhere: less is finer, more "
                                 "is coarser."),
                              {kPercent * range.min, kPercent * range.max, 0, 10, tr(" %")}, change)
                  : numberBox(this, "depthValue", tr("Order"),
                              tr("Greater than 0 lies in front, less than 0 behind."),
                              {range.min, range.max, 1}, change);
    m_add = new QToolButton(this);
    setWords(m_add, isDetail() ? "detailAdd" : "depthAdd", tr("Add"),
             tr("A ball, a box or a half-space in the middle, or what the selected handle holds as a region; "
                "its numbers can then be changed."),
             tr("Add region"));
    m_add->setPopupMode(QToolButton::InstantPopup);
    m_add->setProperty("role", "chip");
    m_remove = chip(this, isDetail() ? "detailRemove" : "depthRemove", tr("Remove"),
                    tr("Removes the chosen region."),
                    [this] { this->change(tr("Remove region"), withoutLayer(layers(), chosenId())); });
    m_numbers = new RegionNumbers(RegionNumbers::Radius::Here, m_shape);
    connect(m_numbers, &RegionNumbers::changed, this,
            [this](const Region<3>& shape) { changeShape(shape, m_feather->value()); });
    m_feather = numberBox<MagnitudeBox>(
        this, isDetail() ? "detailFeather" : "depthFeather", tr("Soft edge"),
        tr("Over what width the size blends into that around it, in the file's units."), {0, 1e9, -1},
        [this](double feather) {
            if (const ValueLayer* own = layer()) changeShape(own->regions.front().shape, feather);
        });
}

void RegionList::makeAddMenu() {
    auto* menu = new QMenu(m_add);
    const auto entry = [&](const QString& text, auto shapeOf) {
        return menu->addAction(text, this, [this, shapeOf] {
            if (m_motion.frame<3>()) addRegion(shapeOf());
        });
    };
    const auto reach = [this] { return kReach * m_motion.frame()->diagonal; };
    entry(tr("Ball"), [=, this] { return Ball<3>{middle(), reach()}; });
    entry(tr("Box"), [=, this] { return Box<3>{middle().array() - reach(), middle().array() + reach()}; });
    entry(tr("Half-space"), [=, this] { return HalfSpace<3>{middle(), Vec3::UnitX()}; });
    m_addSelected = entry(tr("Region of the selected handle"), [this] { return *selectedRegion(); });
    menu->setToolTipsVisible(true);
    m_add->setMenu(menu);
}

void RegionList::arrange() {
    auto* layout = sectionColumn(this);
    QLabel* title = panelTitle(isDetail() ? tr("Finer and coarser") : tr("In front and behind"), this);
    layout->addLayout(sideBySide({title, nullptr, m_add, m_remove}));
    layout->addWidget(m_none);
    layout->addWidget(m_list);
    layout->addWidget(m_row = panelRowIn(isDetail() ? tr("E&dges") : tr("O&rder"), m_value, this));
    auto* shape = bareColumn(m_shape, 10);
    shape->addWidget(m_numbers);
    shape->addLayout(panelRow(tr("Soft ed&ge"), m_feather, m_shape));
    layout->addWidget(m_shape);
    layout->addWidget(m_note);
}

void RegionList::change(const QString& step, ValueLayers layers, const QString& key) {
    Document& document = m_document;
    isDetail() ? document.changeSizes(step, std::move(layers), key)
               : document.changeDepth(step, std::move(layers), key);
}

/// Changes of the numbers in a row merge into one undo step.
void RegionList::changeShape(const Region<3>& shape, double feather) {
    change(tr("Change region"),
           withLayer(layers(), chosenId(),
                     [&](ValueLayer& layer) {
                         layer.regions.front().shape = shape;
                         layer.regions.front().feather = feather;
                     }),
           QStringLiteral("layer shape %1").arg(qulonglong(chosenId())));
}

void RegionList::addRegion(const Region<3>& shape) {
    change(tr("Add size region"), withSizeRegion(layers(), shape, m_brush.edges().now()));
    m_list->setCurrentRow(0);
}

/// Returns the region that the single selected handle holds; null if it holds none.
const Region<3>* RegionList::selectedRegion() const {
    const int handle = m_selection.single();
    return handle < 0 ? nullptr : std::get_if<Region<3>>(&m_document.design().handles[handle].at);
}

void RegionList::allowSelected() {
    allow(m_addSelected, isSolid() && selectedRegion(),
          tr("First select a pin that holds a ball, a box or one side."));
}

const ValueLayers& RegionList::layers() const {
    static const ValueLayers none;
    const Document& document = m_document;
    if (document.isEmpty()) return none;
    return isDetail() ? document.domain().sizes : document.depth();
}

Id RegionList::chosenId() const {
    return layerOf(m_list->currentItem());
}

/// Returns the chosen layer; null if there is none.
const ValueLayer* RegionList::layer() const {
    return layerOf(layers(), chosenId());
}

Vec3 RegionList::middle() const {
    const Points3& rest = m_motion.frame<3>()->rest->points;
    return (rest.rowwise().minCoeff() + rest.rowwise().maxCoeff()) / 2;
}

QString RegionList::nameOf(const ValueLayer& layer) const {
    if (!layer.name.empty()) return QString::fromStdString(layer.name);
    const Region<3>& shape = layer.regions.front().shape;
    if (std::holds_alternative<Ball<3>>(shape)) return isSolid() ? tr("Ball") : tr("Circle");
    if (std::holds_alternative<Box<3>>(shape)) return isSolid() ? tr("Box") : tr("Rectangle");
    if (std::holds_alternative<HalfSpace<3>>(shape)) return isSolid() ? tr("Half-space") : tr("One side");
    return std::holds_alternative<Polygon>(shape) ? tr("Outline") : tr("Blend");
}

QString RegionList::valueText(double value) const {
    const QLocale locale;
    return isDetail() ? tr("%1 %").arg(locale.toString(kPercent * value, 'g', 3))
                      : locale.toString(value, 'g', 3);
}

/// Selects a new layer, so that its value can be edited at once; otherwise the selection stays.
void RegionList::showLayers() {
    {
        const QSignalBlocker quiet(m_list);
        const KeptScroll scroll(*m_list);
        std::vector<Id> before;
        for (int row = 0; row < m_list->count(); ++row) before.push_back(layerOf(m_list->item(row)));
        const bool oneMore = isVisible() && layers().size() == before.size() + 1;
        Id chosen = chosenId();
        m_list->clear();
        for (const ValueLayer& layer : layers() | std::views::reverse) {
            auto* item = new QListWidgetItem(nameOf(layer), m_list);
            item->setFlags(item->flags() | Qt::ItemIsEditable);
            setLayerOf(*item, layer.id);
            item->setData(kValue, valueText(layer.value));
            item->setData(Qt::AccessibleDescriptionRole, valueText(layer.value));
            if (oneMore && std::ranges::find(before, layer.id) == before.end()) chosen = layer.id;
        }
        for (int row = 0; row < m_list->count(); ++row)
            if (layerOf(m_list->item(row)) == chosen) m_list->setCurrentRow(row);
    }
    const bool any = !layers().empty();
    for (QWidget* part : {static_cast<QWidget*>(m_list), m_row, static_cast<QWidget*>(m_remove)})
        part->setVisible(any);
    m_none->setVisible(!any);
    m_add->setVisible(isDetail() && isSolid());
    showNotes();
    allowSelected();
    showChosen();
}

/// Says of a solid what else decides about its sizes.
void RegionList::showNotes() {
    QStringList notes;
    if (isDetail() && isSolid()) {
        const Domain& domain = m_document.domain();
        if (!domain.sizesFile.empty())
            notes << tr("Beneath them: the factors in %1.")
                         .arg(QFileInfo(QString::fromStdString(domain.sizesFile)).fileName());
        if (!domain.refineSurface)
            notes << tr(
                "The surface's triangles are kept, and only the inside changes. “Refine surface” in the "
                "panel “Mesh” allows them to be split, too.");
    }
    m_note->setText(notes.join(QLatin1Char('\n')));
    m_note->setVisible(!notes.isEmpty());
}

void RegionList::showChosen() {
    const ValueLayer* own = layer();
    m_row->setEnabled(own);
    allow(m_remove, own, chooseFirst());
    own ? m_value->put((isDetail() ? kPercent : 1) * own->value) : m_value->clear();
    const SoftRegion* one = own && own->regions.size() == 1 ? &own->regions.front() : nullptr;
    const bool hasNumbers = isSolid() && one && RegionNumbers::canShow(one->shape);
    m_shape->setVisible(hasNumbers);
    if (hasNumbers) {
        const QSignalBlocker quiet(m_feather);
        m_numbers->showRegion(one->shape, m_motion.frame() ? m_motion.frame()->diagonal : 1);
        m_feather->setValue(one->feather);
    }
    tellChosen();
}

/// Defers the edit, because the list is in the middle of its own change.
void RegionList::rename(QListWidgetItem* item) {
    const Id id = layerOf(item);
    const std::string wish = item->text().trimmed().toStdString();
    QMetaObject::invokeMethod(
        this,
        [this, id, wish] {
            const ValueLayer* own = layerOf(layers(), id);
            if (!own) return;
            if (wish.empty() || wish == own->name) return showLayers();
            if (isDetail())
                change(tr("Rename region"), withLayerName(layers(), id, wish));
            else
                renameDepth(m_document, tr("Rename region"), id, wish);
        },
        Qt::QueuedConnection);
}

void RegionList::tellChosen() {
    const ValueLayer* own = isVisible() ? layer() : nullptr;
    emit chosen(own ? own->regions : std::vector<SoftRegion>());
}

void RegionList::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    tellChosen();
}

void RegionList::hideEvent(QHideEvent* event) {
    QWidget::hideEvent(event);
    tellChosen();
}

}  // namespace wend
