#include "app/panels/part_list.h"

#include <QKeyEvent>
#include <QListWidget>
#include <QLocale>
#include <QStandardItemModel>
#include <QWidget>
#include <algorithm>
#include <array>

#include "app/engine/motion/playback.h"
#include "app/engine/shape/mesh_parts.h"
#include "app/engine/shape/shape.h"
#include "app/panels/fields/controls.h"
#include "app/panels/fields/panel_parts.h"
#include "app/panels/fields/reasons.h"
#include "app/panels/list_items.h"
#include "app/project/domain.h"
#include "app/project/edits/part_edits.h"
#include "app/session/shape_motion.h"
#include "app/style/theme.h"

class QLabel;

namespace wend {

namespace {

constexpr double kFullOpacity = 100;
constexpr double kWidestEdge = 200;  // pixels
constexpr double kFarthest = 99999;  // pixels

constexpr std::array kModes{BlendMode::Normal, BlendMode::Multiply, BlendMode::Screen, BlendMode::Add};

QString nameOf(BlendMode mode) {
    switch (mode) {
        case BlendMode::Multiply:
            return PartList::tr("Multiply");
        case BlendMode::Screen:
            return PartList::tr("Screen");
        case BlendMode::Add:
            return PartList::tr("Add");
        case BlendMode::Normal:
            break;
    }
    return PartList::tr("Normal");
}

/// Returns the sheet with which the shape shows a part; null while it does not.
const Sheet* sheetOf(const PicturePart& part, const Texture* texture) {
    if (!texture || !texture->drawn) return nullptr;
    const auto& shown = texture->drawn->parts;
    const auto found = std::ranges::find(shown, part.name, &MeshPart::name);
    return found == shown.end() ? nullptr : &texture->sheets[static_cast<std::size_t>(found - shown.begin())];
}

/// Returns the mode of a part: its own, or else the one with which the shape shows it, which is its layer's.
BlendMode modeOf(const PicturePart& part, const Texture* texture) {
    if (part.blend) return *part.blend;
    const Sheet* sheet = sheetOf(part, texture);
    return sheet ? sheet->blend : BlendMode::Normal;
}

}  // namespace

/// Changes of a part's place in the order over time: to the front or the back from the shown time on, and
/// none of them again.
class PartOrderRow : public QWidget {
    Q_OBJECT

  public:
    PartOrderRow(Document& document, Playback& playback, QWidget* parent = nullptr);
    void showPart(int part);

  private:
    void set(bool front);

    Document& m_document;
    Playback& m_playback;
    QToolButton* m_never = nullptr;
    QLabel* m_times;
    int m_part = -1;
};

PartOrderRow::PartOrderRow(Document& document, Playback& playback, QWidget* parent)
    : QWidget(parent), m_document(document), m_playback(playback), m_times(secondLabel({}, this)) {
    auto* column = bareColumn(this, 6);
    auto* front =
        chip(this, "partFrontFromHere", tr("In Front from Here"),
             tr("From the shown time on the part is in front of all others; before, it stays where it is."),
             [this] { set(true); });
    auto* back =
        chip(this, "partBehindFromHere", tr("Behind from Here"),
             tr("From the shown time on the part is behind all others; before, it stays where it is."),
             [this] { set(false); });
    m_never = chip(this, "partOrderNever", tr("Never"), tr("Removes all changes of the order of this part."),
                   [this] {
                       Domain domain = m_document.domain();
                       domain.parts.at(static_cast<std::size_t>(m_part)).order.clear();
                       m_document.changeDomain(tr("Keep the order"), std::move(domain));
                   });
    m_times->setObjectName(QStringLiteral("partOrderTimes"));
    for (QToolButton* button : {front, back}) column->addLayout(sideBySide({button, nullptr}));
    column->addLayout(sideBySide({m_times, nullptr, m_never}));
}

void PartOrderRow::set(bool front) {
    Document& document = m_document;
    const auto count = static_cast<int>(document.domain().parts.size());
    if (m_part < 0 || m_part >= count) return;
    document.change(front ? tr("In front from here on") : tr("Behind from here on"),
                    withPartInFront(*document.project(), m_part, m_playback.time(), front));
}

void PartOrderRow::showPart(int part) {
    m_part = part;
    if (part < 0) return;
    QStringList times;
    for (const PartOrder& one : m_document.domain().parts.at(static_cast<std::size_t>(part)).order)
        times << tr("%1 s").arg(QLocale().toString(one.time * Playback::kSecondsPerUnit, 'f', 2));
    m_never->setVisible(!times.isEmpty());
    m_times->setVisible(!times.isEmpty());
    m_times->setText(tr("Changes at %1").arg(times.join(QStringLiteral(", "))));
}

PartList::PartList(Document& document, ShapeMotion& motion, Playback& playback, QWidget* parent)
    : QWidget(parent), m_document(document), m_motion(motion), m_list(new QListWidget(this)) {
    makeList();
    makeChips();
    makeFields();
    m_order = new PartOrderRow(document, playback, this);
    auto* layout = sectionColumn(this);
    layout->addLayout(sideBySide({panelTitle(tr("Parts"), this), nullptr, m_lock, m_forward, m_backward}));
    layout->addWidget(m_list);
    m_rows = new QWidget(this);
    auto* rows = bareColumn(m_rows, 8);
    rows->addWidget(panelRowIn(tr("Opac&ity"), m_opacity, this));
    rows->addWidget(m_featherRow = panelRowIn(tr("Soft ed&ge"), m_feather, this));
    rows->addWidget(panelRowIn(tr("&Blend mode"), m_blend, this));
    rows->addWidget(panelRowIn(tr("&Joined to"), m_joined, this));
    m_jointRows = new QWidget(this);
    auto* joint = bareColumn(m_jointRows, 8);
    joint->addWidget(panelRowIn(tr("Joint x"), m_joint[0], this));
    joint->addWidget(panelRowIn(tr("Joint y"), m_joint[1], this));
    rows->addWidget(m_jointRows);
    rows->addWidget(panelRowIn(tr("&Rides on"), m_rides, this));
    rows->addWidget(m_order);
    layout->addWidget(m_rows);
    connect(&m_document, &Document::projectChanged, this, &PartList::showParts);
    connect(&m_motion, &ShapeMotion::frameChanged, this, &PartList::takeFrame);
    showParts();
}

void PartList::makeList() {
    m_list->setObjectName(QStringLiteral("partList"));
    m_list->setFixedHeight(168);
    m_list->setIconSize({kPartIcon, kPartIcon});
    m_list->setDragDropMode(QAbstractItemView::InternalMove);
    m_list->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
    m_list->installEventFilter(this);
    describe(
        m_list, tr("Parts of the picture"),
        tr("The frontmost part is first. Drag a part, or press Alt with the arrow keys, to change what lies "
           "in front; click its eye to hide it; the lock at its end protects it from changes; a "
           "double-click changes "
           "its name."));
    auto* rows = new PartRow(m_list);
    m_list->setItemDelegate(rows);
    connect(rows, &PartRow::lockClicked, this, [this](int row) {
        if (row < static_cast<int>(parts().size())) lock(row, !parts()[static_cast<std::size_t>(row)].locked);
    });
    connect(m_list, &QListWidget::currentRowChanged, this, [this] {
        showChosen();
        emit chosenChanged(chosen());
    });
    connect(m_list, &QListWidget::itemChanged, this, &PartList::takeItem);
    connect(m_list->model(), &QAbstractItemModel::rowsMoved, this,
            [this](const QModelIndex&, int from, int, const QModelIndex&, int to) {
                takeOrder(from, to > from ? to - 1 : to);
            });
}

void PartList::makeChips() {
    m_forward = chip(this, "partForward", tr("Forward"),
                     tr("Brings the part in front of the next one (Alt+Up)."), [this] { move(-1); });
    m_backward = chip(this, "partBackward", tr("Backward"),
                      tr("Brings the part behind the next one (Alt+Down)."), [this] { move(1); });
    m_lock = chip(
        this, "partLock", tr("Lock"),
        tr("The part is seen, but clicks go through it, and it is neither painted nor are its pins moved."),
        [this](bool on) {
            if (chosen() >= 0) lock(chosen(), on);
        });
    m_lock->setCheckable(true);
    showIcons();
}

/// Shows signs, because words would make the buttons wider than the column.
void PartList::showIcons() {
    for (const auto& [button, icon] :
         {std::pair{m_forward, "move-up"}, {m_backward, "move-down"}, {m_lock, "lock"}})
        button->setIcon(wendIcon(QString::fromLatin1(icon), palette()));
}

void PartList::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() != QEvent::PaletteChange) return;
    showIcons();
    showPictures();
}

void PartList::makeFields() {
    m_opacity = numberBox(this, "partOpacity", tr("Opacity"), tr("How much is seen of the part."),
                          {0, kFullOpacity, 0, 1, tr(" %")}, [this](double value) {
                              changeChosen(
                                  tr("Change opacity"),
                                  [value](PicturePart& part) { part.opacity = value / kFullOpacity; },
                                  QStringLiteral("part opacity "));
                          });
    m_feather = numberBox(
        this, "partFeather", tr("Soft edge"),
        tr("How wide the edge is along which the part was cut out. The colours of what is behind it "
           "are removed from it."),
        {0, kWidestEdge, 1, 1, tr(" px")}, [this](double value) {
            changeChosen(
                tr("Change soft edge"), [value](PicturePart& part) { part.feather = value; },
                QStringLiteral("part feather "));
        });
    QStringList modes;
    for (const BlendMode mode : kModes) modes << nameOf(mode);
    m_blend = choiceBox(
        this, "partBlend", tr("Blend mode"),
        tr("How the part is combined with what is below it: Multiply darkens, as a shadow does; Screen "
           "and Add lighten, as light does."),
        modes, &PartList::blend);
    m_joined = choiceBox(
        this, "partJoined", tr("Joined to"),
        tr("Welds the part to another one in the middle of where they overlap at rest: it turns there, and "
           "pulls nothing else."),
        {}, &PartList::join);
    for (int axis = 0; axis < 2; ++axis)
        m_joint[axis] = numberBox(
            this, axis == 0 ? "partJointX" : "partJointY", axis == 0 ? tr("Joint x") : tr("Joint y"),
            tr("Where the part turns at rest, in pixels from the upper left corner: a point in both parts, "
               "marked by a ring on the picture."),
            {-kFarthest, kFarthest, 1, 1, tr(" px")}, [this, axis](double value) { moveJoint(axis, value); });
    m_rides = choiceBox(this, "partRides", tr("Rides on"),
                        tr("The part follows the motion of another one, as eyes do on a face."), {},
                        &PartList::ride);
}

const std::vector<PicturePart>& PartList::parts() const {
    static const std::vector<PicturePart> none;
    return m_document.isEmpty() ? none : m_document.domain().parts;
}

int PartList::chosen() const {
    const int row = m_list->currentRow();
    return row < static_cast<int>(parts().size()) ? row : -1;
}

void PartList::change(const QString& step, std::vector<PicturePart> next, const QString& key) {
    Domain domain = m_document.domain();
    domain.parts = std::move(next);
    m_document.changeDomain(step, std::move(domain), key);
}

/// Consecutive changes of one part with the same key merge.
template <class Change>
void PartList::changeChosen(const QString& step, const Change& change, const QString& key) {
    if (chosen() < 0) return;
    std::vector<PicturePart> next = parts();
    change(next[static_cast<std::size_t>(chosen())]);
    this->change(step, std::move(next), key.isEmpty() ? key : key + QString::number(chosen()));
}

void PartList::showParts() {
    const KeptScroll scroll(*m_list);  // until the rows have their pictures, which decide about their height
    {
        const QSignalBlocker quiet(m_list);
        const QString name = m_list->currentItem() ? m_list->currentItem()->text() : QString();
        const int row = m_list->currentRow();
        m_list->clear();
        int same = -1;
        for (const PicturePart& part : parts()) {
            auto* item = new QListWidgetItem(QString::fromStdString(part.name), m_list);
            item->setFlags((item->flags() | Qt::ItemIsEditable | Qt::ItemIsUserCheckable) &
                           ~Qt::ItemIsDropEnabled);
            item->setCheckState(part.hidden ? Qt::Unchecked : Qt::Checked);
            item->setData(PartRow::kLockedRole, part.locked);
            item->setToolTip(describedPart(part));
            item->setData(Qt::AccessibleDescriptionRole, describedPart(part));
            if (item->text() == name) same = m_list->row(item);
        }
        m_list->setCurrentRow(same >= 0 ? same : std::min(row, m_list->count() - 1));
    }
    setVisible(!parts().empty());
    showPictures();
    showChosen();
}

/// Takes a shape that shows other pictures or modes; poses change nothing here.
void PartList::takeFrame() {
    if (texture().get() == m_texture.get()) return;
    showPictures();
    showBlend();
    allowJoints();
}

std::shared_ptr<const Texture> PartList::texture() const {
    const auto frame = m_motion.frame<2>();
    return frame && frame->built ? frame->built->texture : nullptr;
}

void PartList::showPictures() {
    m_texture = texture();
    const QSignalBlocker quiet(m_list);
    std::vector<Icon> icons;
    const qint64 colours = palette().cacheKey();
    for (int i = 0; i < std::min(m_list->count(), static_cast<int>(parts().size())); ++i) {
        const PicturePart& part = parts()[static_cast<std::size_t>(i)];
        const Sheet* sheet = sheetOf(part, m_texture.get());
        const auto picture = sheet ? sheet->picture : nullptr;
        const bool isJoined = !part.joints.empty();
        const auto known = std::ranges::find_if(m_icons, [&](const Icon& one) {
            return one.picture == picture && one.isJoined == isJoined && one.palette == colours;
        });
        icons.push_back({picture, isJoined, colours,
                         known != m_icons.end() ? known->icon : partIcon(part, picture.get(), palette())});
        m_list->item(i)->setIcon(icons.back().icon);
    }
    m_icons = std::move(icons);
}

void PartList::showChosen() {
    const int part = chosen();
    m_rows->setVisible(part >= 0);
    allow(m_lock, part >= 0, tr("Choose a part."));
    m_lock->setChecked(part >= 0 && parts()[static_cast<std::size_t>(part)].locked);
    allow(m_forward, part > 0, tr("Choose a part that is not in front."));
    allow(m_backward, part >= 0 && part + 1 < m_list->count(), tr("Choose a part that is not at the back."));
    if (part < 0) return;
    const PicturePart& own = parts()[static_cast<std::size_t>(part)];
    m_opacity->put(kFullOpacity * own.opacity);
    m_feather->put(own.feather);
    m_featherRow->setVisible(!own.cutFrom.empty());
    m_jointRows->setVisible(!own.joints.empty());
    for (int axis = 0; axis < 2 && !own.joints.empty(); ++axis)
        m_joint[axis]->put(own.joints.front().at[axis]);
    m_order->showPart(part);
    showBlend();
    fillChoices();
}

/// Shows the mode of the chosen part, which may be known with the next shape only.
void PartList::showBlend() {
    if (chosen() < 0) return;
    const BlendMode mode = modeOf(parts()[static_cast<std::size_t>(chosen())], texture().get());
    m_blend->setCurrentIndex(static_cast<int>(mode));
}

void PartList::fillChoices() {
    const PicturePart& own = parts()[static_cast<std::size_t>(chosen())];
    const auto fill = [&](QComboBox* box, const std::string& now, const auto& mayBe) {
        box->clear();
        box->addItem(tr("Nothing"));
        for (int i = 0; i < static_cast<int>(parts().size()); ++i)
            if (i != chosen() && mayBe(i)) box->addItem(QString::fromStdString(parts()[std::size_t(i)].name));
        box->setCurrentText(now.empty() ? tr("Nothing") : QString::fromStdString(now));
    };
    fill(m_rides, own.ridesOn, [this](int i) { return mayRide(parts(), chosen(), i); });
    fill(m_joined, own.joints.empty() ? std::string() : own.joints.front().to,
         [&](int i) { return own.ridesOn.empty() && parts()[std::size_t(i)].ridesOn.empty(); });
    allowJoints();
}

/// Disables parts that the chosen one does not overlap, once the shape is known: a joint would have no place.
void PartList::allowJoints() {
    const auto frame = m_motion.frame<2>();
    const auto* model = qobject_cast<QStandardItemModel*>(m_joined->model());
    if (chosen() < 0 || !frame) return;
    const PicturePart& own = parts()[static_cast<std::size_t>(chosen())];
    for (int i = 1; i < m_joined->count(); ++i) {
        const std::string to = m_joined->itemText(i).toStdString();
        const bool isJoined = !own.joints.empty() && own.joints.front().to == to;
        const bool isKnown =
            std::ranges::find(frame->rest->parts, to, &MeshPart::name) != frame->rest->parts.end();
        const bool may = isJoined || !isKnown || jointPlace(*frame->rest, own.name, to).has_value();
        model->item(i)->setEnabled(may);
        model->item(i)->setToolTip(
            may ? QString() : tr("These parts do not overlap at rest: there is no place for a joint."));
    }
}

/// Defers the edit, because the list is in the middle of its own change.
void PartList::takeItem(QListWidgetItem* item) {
    const int row = m_list->row(item);
    const std::string name = item->text().trimmed().toStdString();
    const bool hides = item->checkState() == Qt::Unchecked;
    QMetaObject::invokeMethod(
        this,
        [this, row, name, hides] {
            if (row < 0 || row >= static_cast<int>(parts().size())) return;
            const PicturePart& part = parts()[static_cast<std::size_t>(row)];
            if (hides != part.hidden) {
                std::vector<PicturePart> next = parts();
                next[static_cast<std::size_t>(row)].hidden = hides;
                return change(hides ? tr("Hide part") : tr("Show part"), std::move(next));
            }
            const bool isTaken = std::ranges::find(parts(), name, &PicturePart::name) != parts().end();
            if (name == part.name) return;
            if (name.empty() || isTaken) {
                m_document.notify(tr("Another part has this name."));
                return showParts();
            }
            Document& document = m_document;
            document.change(tr("Rename part"), withPartName(*document.project(), row, name));
        },
        Qt::QueuedConnection);
}

void PartList::takeOrder(int from, int to) {
    QMetaObject::invokeMethod(
        this,
        [this, from, to] {
            if (std::max(from, to) >= static_cast<int>(parts().size())) return;
            change(tr("Change order"), withPartMoved(parts(), from, to));
        },
        Qt::QueuedConnection);
}

void PartList::lock(int part, bool locked) {
    std::vector<PicturePart> next = parts();
    next[static_cast<std::size_t>(part)].locked = locked;
    change(locked ? tr("Lock part") : tr("Unlock part"), std::move(next));
}

void PartList::move(int by) {
    const int from = chosen(), to = from + by;
    if (from < 0 || to < 0 || to >= static_cast<int>(parts().size())) return;
    change(tr("Change order"), withPartMoved(parts(), from, to));
}

/// Overrides the blend mode of a file's layer; elsewhere the normal mode is not stored.
void PartList::blend(int mode) {
    changeChosen(tr("Change blend mode"), [mode](PicturePart& own) {
        own.blend = kModes[static_cast<std::size_t>(mode)];
        if (own.blend == BlendMode::Normal && own.layer.empty() && own.cutFrom.empty()) own.blend.reset();
    });
}

void PartList::join(int place) {
    if (chosen() < 0) return;
    const QString to = m_joined->itemText(place);
    std::vector<PicturePart> next = parts();
    PicturePart& own = next[static_cast<std::size_t>(chosen())];
    own.joints.clear();
    if (place > 0) {
        const auto frame = m_motion.frame<2>();
        const auto joint = frame ? jointPlace(*frame->rest, own.name, to.toStdString()) : std::nullopt;
        if (!joint) {
            m_document.notify(tr("These parts do not overlap at rest: there is no place for a joint."));
            return showChosen();
        }
        own.joints.push_back({to.toStdString(), *joint});
    }
    change(own.joints.empty() ? tr("Remove joint") : tr("Join parts"), std::move(next));
}

void PartList::moveJoint(int axis, double value) {
    changeChosen(
        tr("Move joint"),
        [axis, value](PicturePart& own) {
            if (!own.joints.empty()) own.joints.front().at[axis] = value;
        },
        QStringLiteral("part joint "));
}

void PartList::ride(int place) {
    const std::string on = place > 0 ? m_rides->itemText(place).toStdString() : std::string();
    changeChosen(tr("Change what a part rides on"), [on](PicturePart& own) { own.ridesOn = on; });
}

bool PartList::eventFilter(QObject* watched, QEvent* event) {
    if (watched == m_list && event->type() == QEvent::KeyPress) {
        const auto& key = static_cast<const QKeyEvent&>(*event);
        const int by = key.key() == Qt::Key_Up ? -1 : key.key() == Qt::Key_Down ? 1 : 0;
        if (by != 0 && key.modifiers() == Qt::AltModifier) {
            move(by);
            return true;
        }
    }
    return QWidget::eventFilter(watched, event);
}

}  // namespace wend

#include "part_list.moc"
