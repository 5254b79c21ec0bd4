#include "app/panels/pin_list.h"

#include <QApplication>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QPainter>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "app/base/connect_each.h"
#include "app/panels/fields/panel_parts.h"
#include "app/panels/list_items.h"
#include "app/project/design.h"
#include "app/project/edits/handle_edits.h"
#include "app/project/edits/pin_edits.h"
#include "app/session/calm_follower.h"
#include "app/session/pins/pin_traits.h"
#include "app/session/shape_session.h"
#include "app/style/marks.h"
#include "app/style/theme.h"

namespace wend {

namespace {

constexpr int kListHeight = 92, kPinSwatch = 12, kSignColumn = 24, kIcon = 16;
constexpr int kHandleRole = Qt::UserRole, kGroupRole = Qt::UserRole + 1, kColourRole = Qt::UserRole + 2;

QIcon swatch(const QColor& colour) {
    QPixmap picture(kPinSwatch, kPinSwatch);
    picture.fill(Qt::transparent);
    QPainter painter(&picture);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(colour);
    painter.drawEllipse(1, 1, kPinSwatch - 2, kPinSwatch - 2);
    QIcon icon(picture);
    painter.setPen(QPen(Qt::white, 1.5));  // on the accent
    painter.drawEllipse(1, 1, kPinSwatch - 2, kPinSwatch - 2);
    painter.end();
    icon.addPixmap(picture, QIcon::Selected);
    return icon;
}

bool isHeading(const QTreeWidgetItem& item) {
    return !item.data(PinList::Name, kHandleRole).isValid();
}

}  // namespace

PinList::PinList(ShapeSession& session, QWidget* parent)
    : QWidget(parent),
      m_session(session),
      m_list(new QTreeWidget(this)),
      m_empty(secondLabel(tr("No pins yet"), m_list->viewport())) {
    makeList();
    makeIcons();
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(16, 10, 16, 10);
    layout->setSpacing(8);
    layout->addWidget(panelTitle(tr("Pins"), this));
    layout->addWidget(m_list);
    connectEach(this, &PinList::takeSelection, m_list, &QTreeWidget::itemSelectionChanged, m_list,
                &QTreeWidget::currentItemChanged, m_list, &QTreeWidget::itemClicked);
    connect(m_list, &QTreeWidget::itemChanged, this, &PinList::rename);
    connect(m_list, &QTreeWidget::itemCollapsed, this,
            [this](QTreeWidgetItem* item) { m_folded.insert(item->text(Name)); });
    connect(m_list, &QTreeWidget::itemExpanded, this,
            [this](QTreeWidgetItem* item) { m_folded.remove(item->text(Name)); });
    connect(m_list, &QWidget::customContextMenuRequested, this, [this](const QPoint& at) {
        if (!m_session.selection().isEmpty()) emit menuWanted(m_list->viewport()->mapToGlobal(at));
    });
    new CalmFollower(
        m_session.motion(), this, [this] { showPins(); }, &m_session.gestures(), &ShapeGesture::pinsChanged);
    connect(&m_session.playback(), &Playback::timeChanged, this, &PinList::showPins);
    m_empty->setAttribute(Qt::WA_TransparentForMouseEvents);
    m_empty->setAlignment(Qt::AlignCenter);
    m_empty->setWordWrap(true);
    (new QVBoxLayout(m_list->viewport()))->addWidget(m_empty);
    showPins();
}

void PinList::setFills(bool fills) {
    m_list->setMinimumHeight(kListHeight);
    m_list->setMaximumHeight(fills ? QWIDGETSIZE_MAX : kListHeight);
}

void PinList::makeList() {
    m_list->setObjectName(QStringLiteral("pinList"));
    m_list->setFixedHeight(kListHeight);
    m_list->setColumnCount(Lock + 1);
    m_list->setHeaderHidden(true);
    m_list->header()->setStretchLastSection(false);
    m_list->header()->setMinimumSectionSize(kSignColumn);
    m_list->header()->setSectionResizeMode(QHeaderView::Fixed);
    m_list->header()->setSectionResizeMode(Name, QHeaderView::Stretch);
    for (const int column : {Link, Seen, Lock}) m_list->header()->resizeSection(column, kSignColumn);
    m_list->setIndentation(16);
    m_list->setExpandsOnDoubleClick(false);
    m_list->setUniformRowHeights(true);
    m_list->setSelectionMode(QAbstractItemView::ExtendedSelection);
    m_list->setEditTriggers(QAbstractItemView::EditKeyPressed | QAbstractItemView::DoubleClicked);
    m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_list->setContextMenuPolicy(Qt::CustomContextMenu);
    describe(m_list, tr("Pins"),
             tr("Choose pins here; F2 renames, Delete removes, Enter goes to the picture, where the arrow "
                "keys move them. The eye hides, the lock protects from changes; a right-click groups, links "
                "and mirrors."));
    m_list->installEventFilter(this);
    m_list->viewport()->installEventFilter(this);
}

void PinList::makeIcons() {
    const auto sign = [this](const char* name, QIcon::Mode mode) {
        const auto drawn = [&](const QPalette& in, QIcon::Mode as) {
            return wendIcon(QLatin1String(name), in).pixmap(QSize(kIcon, kIcon), devicePixelRatioF(), as);
        };
        QIcon icon(drawn(palette(), mode));
        icon.addPixmap(drawn(primaryPalette(palette()), QIcon::Normal), QIcon::Selected);
        return icon;
    };
    m_link = sign("link", QIcon::Normal);
    m_seen = sign("show", QIcon::Disabled);
    m_hidden = sign("hide", QIcon::Normal);
    m_locked = sign("lock", QIcon::Normal);
    m_unlocked = sign("unlock", QIcon::Disabled);
}

void PinList::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() != QEvent::PaletteChange) return;
    makeIcons();
    m_groups.assign(1, -2);  // forces all rows to be rebuilt
    showPins();
}

QTreeWidgetItem* PinList::rowOf(int handle) const {
    return handle >= 0 && handle < static_cast<int>(m_rows.size()) ? m_rows[handle] : nullptr;
}

QTreeWidgetItem* PinList::headingOf(const QString& group) const {
    const auto found = std::find_if(m_headings.begin(), m_headings.end(),
                                    [&](const auto* item) { return item->text(Name) == group; });
    return found == m_headings.end() ? nullptr : *found;
}

std::vector<int> PinList::handlesOf(const QTreeWidgetItem& item) const {
    if (!isHeading(item)) return {item.data(Name, kHandleRole).toInt()};
    return handlesOfGroup(m_session.document().design(),
                          item.data(Name, kGroupRole).toString().toStdString());
}

/// Does nothing during a drag.
void PinList::showPins() {
    if (m_showing || m_session.motion().isDragging()) return;
    m_showing = true;
    std::vector<int> groups;
    std::vector<std::string> names;
    if (!m_session.document().isEmpty()) {
        const Design& design = m_session.document().design();
        names = groupNames(design);
        for (const Pin& handle : design.handles) {
            const auto at = std::ranges::find(names, handle.traits.group);
            groups.push_back(at == names.end() ? -1 : static_cast<int>(at - names.begin()));
        }
    }
    if (groups != m_groups) arrangeRows(groups, names.size());
    for (std::size_t i = 0; i < names.size(); ++i)
        showHeading(*m_headings[i], QString::fromStdString(names[i]));
    for (int h = 0; h < static_cast<int>(m_rows.size()); ++h) showRow(h);
    m_empty->setVisible(groups.empty());
    m_showing = false;
}

/// Rebuilds all rows and keeps the focus.
void PinList::arrangeRows(const std::vector<int>& groups, std::size_t groupCount) {
    const KeptScroll scroll(*m_list);
    const QTreeWidgetItem* current = m_list->currentItem();
    const int before = current && !isHeading(*current) ? current->data(Name, kHandleRole).toInt() : -1;
    m_list->clear();
    m_list->setRootIsDecorated(groupCount > 0);
    m_groups = groups;
    m_rows.assign(groups.size(), nullptr);
    m_headings.assign(groupCount, nullptr);
    for (std::size_t h = 0; h < groups.size(); ++h) {
        const bool grouped = groups[h] >= 0;
        QTreeWidgetItem** heading = grouped ? &m_headings[static_cast<std::size_t>(groups[h])] : nullptr;
        if (grouped && !*heading) *heading = newRow(nullptr);
        m_rows[h] = newRow(grouped ? *heading : nullptr);
        m_rows[h]->setData(Name, kHandleRole, static_cast<int>(h));
    }
    for (QTreeWidgetItem* heading : m_headings) heading->setFlags(heading->flags() & ~Qt::ItemIsSelectable);
    if (QTreeWidgetItem* row = rowOf(before))
        m_list->setCurrentItem(row, Name, QItemSelectionModel::NoUpdate);
}

QTreeWidgetItem* PinList::newRow(QTreeWidgetItem* heading) {
    auto* item = heading ? new QTreeWidgetItem(heading) : new QTreeWidgetItem(m_list);
    item->setFlags(item->flags() | Qt::ItemIsEditable);
    return item;
}

void PinList::showRow(int handle) {
    const Design& design = m_session.document().design();
    QTreeWidgetItem& item = *m_rows[static_cast<std::size_t>(handle)];
    const Pin& own = design.handles[static_cast<std::size_t>(handle)];
    const QString name = QString::fromStdString(own.name);
    const bool holds = isActive(own, m_session.playback().time());
    const PinTraits& traits = traitsOf(design, handle);
    if (item.text(Name) != name) item.setText(Name, name);
    const QColor colour = pinColour(handle, traits);
    if (item.data(Name, kColourRole).value<QColor>() != colour) {
        item.setData(Name, kColourRole, colour);
        item.setIcon(Name, swatch(colour));
    }
    QFont font = m_list->font();
    font.setItalic(!holds);
    if (item.font(Name) != font) item.setFont(Name, font);
    const QString tip = holds ? QString() : tr("Does not hold at the time shown.");
    if (item.toolTip(Name) != tip) item.setToolTip(Name, tip);
    showSigns(item, isLinked(design, handle), traits.hidden, traits.locked);
    const bool selected = m_session.selection().contains(handle);
    if (item.isSelected() == selected) return;
    item.setSelected(selected);
    const bool folded = item.parent() && !item.parent()->isExpanded();
    if (m_session.selection().single() == handle && !folded) m_list->scrollToItem(&item);
}

/// Bold while something of it is selected, which may be folded away.
void PinList::showHeading(QTreeWidgetItem& item, const QString& group) {
    const Design& design = m_session.document().design();
    const auto handles = handlesOfGroup(design, group.toStdString());
    const auto all = [&](auto test) { return std::all_of(handles.begin(), handles.end(), test); };
    if (item.text(Name) != group) item.setText(Name, group);
    item.setData(Name, kGroupRole, group);
    const bool open = !m_folded.contains(group);
    if (item.isExpanded() != open) item.setExpanded(open);
    QFont font = m_list->font();
    font.setBold(!all([&](int h) { return !m_session.selection().contains(h); }));
    if (item.font(Name) != font) item.setFont(Name, font);
    showSigns(item, false, all([&](int h) { return traitsOf(design, h).hidden; }),
              all([&](int h) { return traitsOf(design, h).locked; }));
}

void PinList::showSigns(QTreeWidgetItem& item, bool linked, bool hidden, bool locked) {
    const auto show = [&item](Column column, int state, const QIcon& icon, const QString& words) {
        if (item.data(column, Qt::UserRole) == state) return;
        item.setData(column, Qt::UserRole, state);
        item.setIcon(column, icon);
        item.setToolTip(column, words);
        item.setData(column, Qt::AccessibleTextRole, words);
    };
    show(Link, linked, linked ? m_link : QIcon(), linked ? tr("Moves together with others") : QString());
    show(Seen, hidden, hidden ? m_hidden : m_seen,
         hidden ? tr("Hidden: a click shows it") : tr("A click hides it"));
    show(Lock, locked, locked ? m_locked : m_unlocked,
         locked ? tr("Locked: a click unlocks it") : tr("A click locks it"));
}

/// Selecting a heading selects its group.
void PinList::takeSelection() {
    if (m_showing || m_session.document().isEmpty()) return;
    std::vector<int> handles;
    for (const QTreeWidgetItem* item : m_list->selectedItems())
        handles.push_back(item->data(Name, kHandleRole).toInt());
    const QTreeWidgetItem* current = m_list->currentItem();
    if (handles.empty() && current && isHeading(*current)) handles = handlesOf(*current);
    m_session.selection().set(std::move(handles));
    showPins();  // also where nothing has changed but the list itself
}

/// Renames a group later: its row is still being edited, and rows may move.
void PinList::rename(QTreeWidgetItem* item, int column) {
    if (m_showing || column != Name) return;
    const QString name = item->text(Name).trimmed();
    if (isHeading(*item)) {
        const QString group = item->data(Name, kGroupRole).toString();
        later([this, group, name] {
            if (!name.isEmpty()) renameGroup(m_session.document(), m_session.pins(), group, name);
        });
    } else {
        const int handle = item->data(Name, kHandleRole).toInt();
        later([this, handle, name] { renamePin(handle, name.toStdString()); });
    }
}

/// Runs a change after the editor has closed and the list has been updated.
void PinList::later(const std::function<void()>& change) {
    QMetaObject::invokeMethod(
        this,
        [this, change, opened = m_session.document().generation()] {
            if (m_session.document().generation() == opened) change();
            showPins();
        },
        Qt::QueuedConnection);
}

void PinList::renamePin(int handle, const std::string& name) {
    if (handle >= m_session.pins().count() || name.empty()) return;
    Document& document = m_session.document();
    if (name != document.design().handles.at(static_cast<std::size_t>(handle)).name)
        renameHandle(document, tr("Rename"), handle, name);
}

/// Applies a click on a sign to all selected pins if its row is selected.
bool PinList::takePress(const QMouseEvent& press) {
    const QModelIndex index = m_list->indexAt(press.position().toPoint());
    const QTreeWidgetItem* item = m_list->itemAt(press.position().toPoint());
    if (!item || press.button() != Qt::LeftButton || index.column() < Seen) return false;
    std::vector<int> handles = handlesOf(*item);
    if (item->isSelected()) handles = m_session.selection().handles();
    const bool on = !item->data(index.column(), Qt::UserRole).toBool();
    index.column() == Seen ? wend::setHidden(m_session.document(), m_session.pins(), handles, on)
                           : setLocked(m_session.document(), m_session.pins(), handles, on);
    return true;
}

bool PinList::takeKey(QKeyEvent& key, bool overrides) {
    const bool enter = key.key() == Qt::Key_Return || key.key() == Qt::Key_Enter;
    if (!enter && key.key() != Qt::Key_Delete) return false;
    key.accept();
    if (overrides) return true;
    if (enter)
        emit done();
    else
        m_session.removeSelected();
    return true;
}

bool PinList::eventFilter(QObject* watched, QEvent* event) {
    const bool pressed = event->type() == QEvent::KeyPress || event->type() == QEvent::ShortcutOverride;
    // Keys that a name editor ignores must not reach the list.
    const bool typing = m_list->viewport()->isAncestorOf(QApplication::focusWidget());
    if (watched == m_list && pressed && !typing)
        return takeKey(static_cast<QKeyEvent&>(*event), event->type() == QEvent::ShortcutOverride);
    const bool clicked =
        event->type() == QEvent::MouseButtonPress || event->type() == QEvent::MouseButtonDblClick;
    if (watched == m_list->viewport() && clicked) return takePress(static_cast<QMouseEvent&>(*event));
    return QWidget::eventFilter(watched, event);
}

}  // namespace wend
