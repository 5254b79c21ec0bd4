#include "app/panels/region_list.h"

#include <QItemDelegate>
#include <QListWidget>
#include <QLocale>
#include <QPainter>
#include <QToolButton>

#include "app/panels/fields/number_boxes.h"
#include "app/panels/fields/panel_parts.h"
#include "app/panels/fields/reasons.h"
#include "app/project/edits/handle_edits.h"
#include "app/project/options/options.h"

namespace wend {

namespace {

constexpr int kValue = Qt::UserRole;  // of an item, in words
constexpr double kPercent = 100;

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

RegionList::RegionList(ShapeSession& session, RegionsOf of, QWidget* parent)
    : QWidget(parent),
      m_session(session),
      m_of(of),
      m_none(secondLabel(
          isDetail() ? tr("The mesh is equally fine everywhere: brush over what should be finer or coarser.")
                     : tr("Nothing has an order of its own: brush over what should lie in front or behind."),
          this)),
      m_list(new QListWidget(this)),
      m_value(new ExactBox(this)),
      m_remove(new QToolButton(this)) {
    makeControls();
    arrange();
    connectControls();
    showRegions();
}

void RegionList::makeControls() {
    const QString id = isDetail() ? QStringLiteral("detail") : QStringLiteral("depth");
    m_list->setObjectName(id + QStringLiteral("Regions"));
    m_list->setFixedHeight(96);
    m_list->setItemDelegate(new ValueDelegate(m_list));
    m_list->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
    describe(m_list, isDetail() ? tr("Where the mesh is finer or coarser") : tr("What lies in front"),
             tr("The strokes and regions so far; where two overlap, the upper one counts. A click shows "
                "where it lies and its number, a double-click changes its name."));
    const Range range = option(isDetail() ? "domain.sizes[].factor" : "depth[].order").range;
    const double unit = isDetail() ? kPercent : 1;
    m_value->setObjectName(id + QStringLiteral("Value"));
    m_value->setRange(unit * range.min, unit * range.max);
    m_value->setDecimals(isDetail() ? 0 : 1);
    m_value->setSuffix(isDetail() ? tr(" %") : QString());
    m_value->setSingleStep(isDetail() ? 10 : 1);
    describe(m_value, isDetail() ? tr("Length of edges") : tr("Order"),
             isDetail()
                 ? tr("How long edges are there, compared with elsewhere: less is finer, more is coarser.")
                 : tr("Greater than 0 lies in front, less than 0 behind."));
    m_remove->setObjectName(id + QStringLiteral("Remove"));
    m_remove->setText(tr("Remove"));
    m_remove->setProperty("role", "chip");
    describe(m_remove, tr("Remove"), tr("Removes the chosen region."));
}

void RegionList::arrange() {
    auto* layout = sectionColumn(this);
    QLabel* title = panelTitle(isDetail() ? tr("Finer and coarser") : tr("In front and behind"), this);
    layout->addLayout(sideBySide({title, nullptr, m_remove}));
    layout->addWidget(m_none);
    layout->addWidget(m_list);
    layout->addWidget(m_row = panelRowIn(isDetail() ? tr("E&dges") : tr("O&rder"), m_value, this));
}

void RegionList::connectControls() {
    connect(&m_session.document(), &Document::projectChanged, this, &RegionList::showRegions);
    connect(m_list, &QListWidget::currentRowChanged, this, &RegionList::showChosen);
    connect(m_list, &QListWidget::itemChanged, this, &RegionList::rename);
    connect(m_value, &QDoubleSpinBox::valueChanged, this, [this] {
        const double value = m_value->exact() / (isDetail() ? kPercent : 1);
        change(
            isDetail() ? tr("Change edges") : tr("Change order"),
            [&](const auto& all) { return withRegionsValue(all, group(), value); },
            QStringLiteral("regions %1 %2").arg(static_cast<int>(m_of)).arg(group()));
    });
    connect(m_remove, &QToolButton::clicked, this, [this] {
        change(tr("Remove region"), [this](const auto& all) { return withoutRegions(all, group()); });
    });
}

template <class Edit>
void RegionList::change(const QString& step, const Edit& edit, const QString& key) {
    Document& document = m_session.document();
    if (!isDetail()) return document.changeDepth(step, edit(document.depth()), key);
    Domain next = document.domain();
    next.sizes = edit(next.sizes);
    document.changeDomain(step, std::move(next), key);
}

/// Pictures have them.
std::vector<NamedRegions> RegionList::groups() const {
    const Document& document = m_session.document();
    if (document.dimension() != 2) return {};
    return isDetail() ? namedRegions(document.domain().sizes) : namedRegions(document.depth());
}

/// The place in groups(), which has the topmost last; −1: none is chosen.
int RegionList::group() const {
    return m_list->currentRow() < 0 ? -1 : m_list->count() - 1 - m_list->currentRow();
}

QString RegionList::nameOf(const NamedRegions& group) const {
    if (!group.name.empty()) return QString::fromStdString(group.name);
    const Region<3>& shape = group.regions.front().shape;
    return std::holds_alternative<Ball<3>>(shape)        ? tr("Circle")
           : std::holds_alternative<Box<3>>(shape)       ? tr("Rectangle")
           : std::holds_alternative<HalfSpace<3>>(shape) ? tr("One side")
                                                         : tr("Outline");
}

QString RegionList::valueText(double value) const {
    const QLocale locale;
    return isDetail() ? tr("%1 %").arg(locale.toString(kPercent * value, 'g', 3))
                      : locale.toString(value, 'g', 3);
}

/// Selects a new region, so that its number can be edited at once; otherwise the selection keeps its index.
void RegionList::showRegions() {
    const auto all = groups();
    {
        const QSignalBlocker quiet(m_list);
        const int count = static_cast<int>(all.size());
        QStringList before;
        for (int row = 0; row < m_list->count(); ++row) before << m_list->item(row)->text();
        const bool oneMore = isVisible() && count == before.size() + 1;
        const int chosen = group() < 0 ? -1 : count - 1 - group();
        const QString name = group() < 0 ? QString() : m_list->currentItem()->text();
        m_list->clear();
        int fresh = -1;
        for (auto group = all.rbegin(); group != all.rend(); ++group) {
            auto* item = new QListWidgetItem(nameOf(*group), m_list);
            item->setFlags(item->flags() | Qt::ItemIsEditable);
            item->setData(kValue, valueText(group->value));
            item->setData(Qt::AccessibleDescriptionRole, valueText(group->value));
            if (oneMore && fresh < 0 && !before.contains(item->text())) fresh = m_list->row(item);
        }
        const QListWidgetItem* same = m_list->item(chosen);
        m_list->setCurrentRow(fresh >= 0 ? fresh : same && same->text() == name ? chosen : -1);
    }
    m_list->setVisible(!all.empty());
    m_row->setVisible(!all.empty());
    m_remove->setVisible(!all.empty());
    m_none->setVisible(all.empty());
    showChosen();
}

void RegionList::showChosen() {
    const bool has = group() >= 0;
    m_row->setEnabled(has);
    allow(m_remove, has, chooseFirst());
    if (has)
        m_value->put((isDetail() ? kPercent : 1) * groups()[group()].value);
    else
        m_value->clear();
    tellChosen();
}

/// The list is in the middle of the change.
void RegionList::rename(QListWidgetItem* item) {
    const int place = m_list->count() - 1 - m_list->row(item);
    const std::string wish = item->text().trimmed().toStdString();
    QMetaObject::invokeMethod(
        this,
        [this, place, wish] {
            const auto all = groups();
            if (place >= static_cast<int>(all.size())) return;
            if (wish.empty() || wish == all[place].name) return showRegions();
            Document& document = m_session.document();
            if (isDetail())
                change(tr("Rename region"),
                       [&](const auto& regions) { return withRegionsName(regions, place, wish); });
            else
                renameDepth(document, tr("Rename region"), place, wish);
        },
        Qt::QueuedConnection);
}

void RegionList::tellChosen() {
    const bool has = group() >= 0 && isVisible();
    emit chosen(has ? groups()[group()].regions : std::vector<MaterialRegion>());
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
