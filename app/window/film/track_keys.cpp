// Key poses on the tracks: what mouse, keys and menus do with them.

#include <QKeyEvent>
#include <QMenu>
#include <algorithm>
#include <cmath>

#include "app/project/design.h"
#include "app/session/pins/key_poses.h"
#include "app/window/film/ease_editor.h"
#include "app/window/film/time_ruler.h"
#include "app/window/film/time_strip.h"
#include "app/window/film/track_view.h"

namespace wend {

namespace {

constexpr double kKeyReach = 6;  // pixels around a key

}  // namespace

std::vector<double> TrackView::keysIn(int row) const {
    std::vector<double> times;
    for (const Bar& bar : m_rows[static_cast<std::size_t>(row)].bars)
        times.insert(times.end(), {bar.time.start, bar.time.end});
    std::ranges::sort(times);
    times.erase(std::unique(times.begin(), times.end()), times.end());
    return times;
}

/// Returns the time at which a key is drawn while keys or bars are dragged.
double TrackView::shownTime(int handle, double time) const {
    if (m_grabbedKeys && isChosen(KeyId{handle, time})) return time + m_grabbedKeys->shift;
    if (m_grabbed && isAmong(endsOf(m_grabbed->motions), KeyId{handle, time}))
        return carried(time, m_grabbed->span, m_grabbed->time);
    return time;
}

QPointF TrackView::keySpot(const KeyId& key) const {
    return {xOf(shownTime(key.handle, key.time)), rowRect(key.handle).center().y()};
}

/// Returns the nearest key within reach. An end of one of several chosen bars is none: it scales them.
std::optional<KeyId> TrackView::keyAt(const QPointF& at) const {
    const int row = rowAt(at);
    if (row < 0) return {};
    std::optional<KeyId> best;
    double least = kKeyReach;
    for (const double time : keysIn(row))
        if (const double off = std::abs(xOf(time) - at.x()); off <= least)
            least = off, best = KeyId{row, time};
    const bool scales = best && m_chosen.size() > 1 && isAmong(endsOf(m_chosen), *best);
    return scales ? std::nullopt : best;
}

/// Also selects the pins of the keys.
void TrackView::chooseKeys(std::vector<KeyId> keys) {
    m_keys = std::move(keys);
    m_chosen.clear();
    std::vector<int> pins;
    for (const KeyId& key : m_keys) pins.push_back(key.handle);
    m_session.selection().set(std::move(pins));
    viewport()->update();
    emit choiceChanged();
}

/// Returns the chosen keys whose pins are not locked.
std::vector<KeyId> TrackView::changeableKeys() const {
    std::vector<KeyId> keys = m_keys;
    std::erase_if(keys, [this](const KeyId& key) { return !m_session.gestures().mayChange(key.handle); });
    return keys;
}

bool TrackView::pressKey(const QPointF& at, bool joins) {
    const auto key = keyAt(at);
    if (!key) return false;
    const bool among = isChosen(*key);
    std::vector<KeyId> next = joins || among ? m_keys : std::vector<KeyId>();
    if (joins && among)
        std::erase(next, *key);
    else if (!among)
        next.push_back(*key);
    chooseKeys(std::move(next));
    if (isChosen(*key) && m_session.gestures().mayChange(key->handle))
        m_grabbedKeys = GrabbedKeys{*key, timeAt(at.x()), 0, among && !joins};
    return true;
}

void TrackView::dragKeys(double time) {
    GrabbedKeys& grabbed = *m_grabbedKeys;
    constexpr double kDraggedKey = 3;  // pixels before a press is a drag
    if (grabbed.shift == 0 && std::abs(xOf(time) - xOf(grabbed.at)) < kDraggedKey) return;
    const std::vector<KeyId> keys = changeableKeys();
    const double to = snapped(grabbed.key.time + (time - grabbed.at), keys);
    grabbed.shift = fittedShift(m_session.document().design(), keys, to - grabbed.key.time);
    viewport()->update();
}

void TrackView::dropKeys(const GrabbedKeys& grabbed) {
    if (grabbed.shift != 0)
        moveKeys(grabbed.shift);
    else if (grabbed.alone)
        chooseKeys({grabbed.key});
}

/// Moves the chosen keys, which stay chosen.
void TrackView::moveKeys(double by, const QString& mergeKey) {
    const std::vector<KeyId> keys = changeableKeys();
    Document& document = m_session.document();
    const double shift = keys.empty() ? 0 : fittedShift(document.design(), keys, by);
    if (shift == 0) return;
    m_session.playback().setPlaying(false);
    QString name = mergeKey;
    for (const KeyId& key : keys)
        name += mergeKey.isEmpty() ? QString() : QStringLiteral(" %1").arg(key.handle);
    const auto next = withKeysMoved(*document.project(), keys, shift);
    std::vector<KeyId> moved = m_keys;
    for (KeyId& key : moved)
        if (isAmong(keys, key)) {
            const auto times = keyTimes(designOf(*next), key.handle);
            key.time = *std::ranges::min_element(
                times, {}, [to = key.time + shift](double time) { return std::abs(time - to); });
        }
    document.change(keys.size() > 1 ? tr("Move keys") : tr("Move key"), next, name);
    chooseKeys(std::move(moved));
}

/// Changes keys, or says that there is nothing to change.
void TrackView::changeKeys(const QString& what, Design after) {
    bool changes = false;
    for (int row = 0; row < static_cast<int>(m_rows.size()); ++row) {
        const std::size_t motions = after.handles[static_cast<std::size_t>(row)].motions.size();
        changes = changes || motions != m_rows[static_cast<std::size_t>(row)].bars.size() ||
                  keyTimes(after, row) != keysIn(row);
    }
    if (changes) return change(what, std::move(after));
    m_session.document().notify(
        tr("Nothing changes: where a pin begins it is at rest, and rotations keep their course."));
}

void TrackView::removeKeys() {
    if (const auto keys = changeableKeys(); !keys.empty())
        changeKeys(keys.size() > 1 ? tr("Remove keys") : tr("Remove key"),
                   withoutKeys(m_session.document().design(), keys));
}

void TrackView::copyChosen() {
    m_copied = copyKeys(m_session, m_keys.empty() ? endsOf(m_chosen) : m_keys);
}

/// Sets the copied keys at the shown time: those of a single pin on the pins that are selected now.
void TrackView::paste(bool mirrored) {
    if (m_copied.empty()) return;
    const auto copies = mirrored ? mirroredKeys(m_session, m_copied) : forSelected(m_session, m_copied);
    const double time = m_scale->onFrame(m_session.playback().time());
    chooseKeys(pasteKeys(m_session, copies, time, tr("Paste keys")));
    m_session.playback().setTime(time);
}

/// Sets the mirror images of the chosen keys at their own times.
void TrackView::mirrorKeys() {
    const auto copies = copyKeys(m_session, m_keys);
    const double first = std::ranges::min(m_keys, {}, &KeyId::time).time;
    chooseKeys(pasteKeys(m_session, mirroredKeys(m_session, copies), first, tr("Mirror keys")));
}

void TrackView::addEasings(QMenu& menu, const KeyId& key) {
    const KeyEase now = easeAt(m_session.document().design(), key);
    const std::pair<QString, KeyEase> kinds[] = {{tr("&Linear"), {false, false}},
                                                 {tr("Slow &before It"), {true, false}},
                                                 {tr("Slow &after It"), {false, true}},
                                                 {tr("Slow on B&oth Sides"), {true, true}}};
    menu.addSection(tr("Easing"));
    for (const auto& [name, ease] : kinds) {
        QAction* action = menu.addAction(name, this, [this, ease = ease] {
            change(tr("Change easing"), withKeyEase(m_session.document().design(), changeableKeys(), ease));
        });
        action->setCheckable(true);
        action->setChecked(now == ease);
    }
}

std::vector<MotionId> TrackView::easedMotions() const {
    return m_keys.empty() ? changeable() : motionsBetween(m_session.document().design(), changeableKeys());
}

std::optional<ShownProgress> TrackView::shownEase() const {
    const auto motions = easedMotions();
    if (motions.empty()) return {};
    return shownProgress(m_session.document().design(), motions.front());
}

void TrackView::setProgress(const Progress& progress, const QString& mergeKey) {
    if (const auto motions = easedMotions(); !motions.empty())
        easeMotions(m_session, motions, progress, tr("Change easing"), mergeKey);
}

void TrackView::holdChosen() {
    const Design& design = m_session.document().design();
    std::vector<KeyId> keys;
    for (const MotionId& id : easedMotions())
        keys.push_back({id.handle, wend::timeOf(design, id.handle, id.motion).start});
    if (!keys.empty()) changeKeys(tr("Hold"), withKeysHeld(design, keys));
}

/// Opens the curve beside the tracks, or brings it back.
void TrackView::editEase() {
    auto* editor = findChild<EaseEditor*>();
    if (!editor) {
        editor = new EaseEditor(*this);
        editor->adjustSize();
        constexpr int kFrame = 40;  // pixels, of the window's title
        const QPoint corner = mapToGlobal(QPoint(width(), 0));
        editor->move(corner - QPoint(editor->width() + kFrame, editor->height() + kFrame));
    }
    editor->show();
    editor->raise();
    editor->activateWindow();
}

/// Hides the curve editor, which edits the bars shown here.
void TrackView::hideEvent(QHideEvent*) {
    if (auto* editor = findChild<EaseEditor*>()) editor->hide();
}

void TrackView::addEaseEditor(QMenu& menu) {
    menu.addAction(tr("Easing C&urve…") + QStringLiteral("\tE"), this, &TrackView::editEase);
}

void TrackView::fillMenu(QMenu& menu, const KeyId& key) {
    addEasings(menu, key);
    addEaseEditor(menu);
    menu.addSeparator();
    menu.addAction(tr("&Hold to the Next"), this, [this] {
        changeKeys(tr("Hold"), withKeysHeld(m_session.document().design(), changeableKeys()));
    });
    menu.addAction(tr("&Mirror"), this, &TrackView::mirrorKeys);
    menu.addSeparator();
    menu.addAction(tr("&Copy") + QStringLiteral("\tCtrl+C"), this, &TrackView::copyChosen);
    addPasting(menu);
    menu.addSeparator();
    menu.addAction((m_keys.size() > 1 ? tr("&Remove Keys") : tr("&Remove Key")) + QStringLiteral("\tDel"),
                   this, &TrackView::removeKeys);
}

void TrackView::addPasting(QMenu& menu) {
    menu.addAction(tr("&Paste at the Time Shown") + QStringLiteral("\tCtrl+V"), this,
                   [this] { paste(false); })
        ->setEnabled(!m_copied.empty());
    menu.addAction(tr("Paste M&irrored") + QStringLiteral("\tCtrl+Shift+V"), this, [this] { paste(true); })
        ->setEnabled(!m_copied.empty());
}

/// Returns whether a key is for the tracks rather than for the window.
bool TrackView::takesKey(const QKeyEvent& event) const {
    const bool chosen = !m_chosen.empty() || !m_keys.empty();
    const auto is = [&event](Qt::KeyboardModifiers modifiers, int key) {
        return event.modifiers() == modifiers && event.key() == key;
    };
    constexpr auto kBoth = Qt::ControlModifier | Qt::ShiftModifier;
    return (chosen && (is({}, Qt::Key_Delete) || is({}, Qt::Key_E) || is(Qt::ControlModifier, Qt::Key_C))) ||
           (!m_copied.empty() && (is(Qt::ControlModifier, Qt::Key_V) || is(kBoth, Qt::Key_V))) ||
           (end() > 0 && (is({}, Qt::Key_I) || is({}, Qt::Key_O) || is(Qt::ShiftModifier, Qt::Key_M)));
}

bool TrackView::keyCommand(const QKeyEvent& event) {
    if (!takesKey(event)) return false;
    switch (event.key()) {
        case Qt::Key_Delete:
            removeChosen();
            break;
        case Qt::Key_E:
            editEase();
            break;
        case Qt::Key_C:
            copyChosen();
            break;
        case Qt::Key_V:
            paste(event.modifiers() & Qt::ShiftModifier);
            break;
        case Qt::Key_I:
            m_ruler->markCycle(0);
            break;
        case Qt::Key_O:
            m_ruler->markCycle(1);
            break;
        default:
            m_ruler->addMarker();
    }
    return true;
}

}  // namespace wend
