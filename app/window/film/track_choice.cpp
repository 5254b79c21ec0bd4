#include "app/window/film/track_choice.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "app/base/connect_each.h"
#include "app/project/design.h"
#include "app/project/project.h"
#include "app/session/pins/mirroring.h"

namespace wend {

namespace {

/// Returns where the pins' paths start.
std::vector<Vec3> keyStarts(const ShownPins& pins) {
    std::vector<Vec3> starts;
    for (int h = 0; h < pins.count(); ++h) {
        const auto own = pins.pathStarts(h);
        starts.push_back(own.empty() ? Vec3(Vec3::Zero()) : meanOf(own));
    }
    return starts;
}

/// Returns copies for other pins: those of a single pin for the given ones, if these are others.
std::vector<CopiedKey> forPins(const std::vector<int>& pins, const std::vector<CopiedKey>& copies) {
    std::set<int> from;
    for (const CopiedKey& copy : copies) from.insert(copy.handle);
    if (from.size() != 1 || pins.empty() || std::ranges::count(pins, *from.begin()) > 0) return copies;
    std::vector<CopiedKey> others;
    for (CopiedKey copy : copies)
        for (const int handle : pins) copy.handle = handle, others.push_back(copy);
    return others;
}

}  // namespace

TrackChoice::TrackChoice(ShapeSession& session, QObject* parent) : QObject(parent), m_session(session) {
    const Document& document = session.document();
    connectEach(this, &TrackChoice::prune, &document, &Document::opened, &document,
                &Document::projectChanged);
}

Id TrackChoice::idOf(int handle) const {
    return design().handles.at(handle).id;
}

/// Returns −1 if the pin is gone.
int TrackChoice::placeOf(Id pin) const {
    if (m_session.document().isEmpty()) return -1;
    const auto& pins = design().handles;
    const auto found = std::ranges::find(pins, pin, &Pin::id);
    return found == pins.end() ? -1 : static_cast<int>(found - pins.begin());
}

/// Forgets what is gone.
void TrackChoice::prune() {
    std::erase_if(m_bars, [&](const auto& bar) {
        const int at = placeOf(bar.first);
        return at < 0 || bar.second >= std::ssize(design().handles[at].motions);
    });
    std::erase_if(m_keys, [&](const auto& key) {
        const int at = placeOf(key.first);
        return at < 0 || !isAmong(keyTimes(design(), at), key.second);
    });
    emit changed();
}

std::vector<MotionId> TrackChoice::bars() const {
    std::vector<MotionId> bars;
    for (const auto& [pin, motion] : m_bars) bars.push_back({placeOf(pin), motion});
    return bars;
}

std::vector<KeyId> TrackChoice::keys() const {
    std::vector<KeyId> keys;
    for (const auto& [pin, time] : m_keys) keys.push_back({placeOf(pin), time});
    return keys;
}

void TrackChoice::set(const std::vector<MotionId>& bars, const std::vector<KeyId>& keys) {
    m_bars.clear();
    m_keys.clear();
    for (const KeyId& key : keys) m_keys.push_back({idOf(key.handle), key.time});
    if (keys.empty())
        for (const MotionId& bar : bars) m_bars.push_back({idOf(bar.handle), bar.motion});
    emit changed();
}

void TrackChoice::choose(const std::vector<MotionId>& bars, const std::vector<KeyId>& keys) {
    set(bars, keys);
    std::vector<int> pins;
    for (const MotionId& bar : this->bars()) pins.push_back(bar.handle);
    for (const KeyId& key : keys) pins.push_back(key.handle);
    m_session.selection().set(pins);
}

std::vector<KeyId> TrackChoice::endsOf(const std::vector<MotionId>& bars) const {
    std::vector<KeyId> ends;
    for (const MotionId& bar : bars) {
        const MotionTime time = timeOf(design(), bar.handle, bar.motion);
        ends.insert(ends.end(), {{bar.handle, time.start}, {bar.handle, time.end}});
    }
    return ends;
}

// --- Edits ---

void TrackChoice::change(const QString& what, Design after) {
    m_session.playback().setPlaying(false);
    m_session.document().changeDesign(what, std::move(after));
}

/// Changes keys, or shows a notice that there is nothing to change.
void TrackChoice::changeKeys(const QString& what, Design after) {
    bool changes = false;
    for (int h = 0; h < std::ssize(after.handles); ++h)
        changes = changes || keyTimes(after, h) != keyTimes(design(), h) ||
                  after.handles[h].motions.size() != design().handles[h].motions.size();
    if (changes) return change(what, std::move(after));
    m_session.document().notify(
        tr("Nothing changes: where a pin begins it is at rest, and rotations keep their course."));
}

void TrackChoice::moveBars(const std::vector<MotionId>& bars, const MotionTime& span, const QString& what,
                           const QString& mergeKey) {
    m_session.playback().setPlaying(false);
    Document& document = m_session.document();
    document.change(what, withMotionSpan(*document.project(), bars, span), mergeKey);
}

void TrackChoice::moveKeys(double by, const QString& mergeKey) {
    const std::vector<KeyId> moving = changeableKeys();
    const double shift = moving.empty() ? 0 : fittedShift(design(), moving, by);
    if (shift == 0) return;
    m_session.playback().setPlaying(false);
    Document& document = m_session.document();
    const auto next = withKeysMoved(*document.project(), moving, shift);
    std::vector<KeyId> moved = keys();
    for (KeyId& key : moved)
        if (isAmong(moving, key)) {
            const auto times = keyTimes(designOf(*next), key.handle);
            key.time = *std::ranges::min_element(
                times, {}, [to = key.time + shift](double time) { return std::abs(time - to); });
        }
    document.change(moving.size() > 1 ? tr("Move keys") : tr("Move key"), next, mergeKey);
    choose(moved);
}

/// Returns the name by which steps merge that edit the same motions.
QString TrackChoice::stepName(QString what, const std::vector<MotionId>& motions) const {
    for (const MotionId& id : motions)
        what += QStringLiteral(" %1 %2").arg(qulonglong(idOf(id.handle))).arg(id.motion);
    return what;
}

void TrackChoice::nudge(double by) {
    const auto motions = easedMotions();
    if (motions.empty()) return;
    if (!m_keys.empty()) return moveKeys(by, stepName(QStringLiteral("%1 keys").arg(m_keys.size()), motions));
    const MotionTime span = spanOf(design(), motions);
    moveBars(motions, {span.start + by, span.end + by}, tr("Move in time"),
             stepName(QStringLiteral("track"), motions));
}

void TrackChoice::setEase(Ease ease) {
    if (const auto own = changeableBars(); !own.empty())
        change(tr("Change easing"), withMotionEase(design(), own, ease));
}

void TrackChoice::setKeyEase(const KeyEase& ease) {
    if (const auto own = changeableKeys(); !own.empty())
        change(tr("Change easing"), withKeyEase(design(), own, ease));
}

void TrackChoice::straighten() {
    if (const auto own = changeableBars(); !own.empty())
        change(tr("Straighten"), straightened(design(), own));
}

void TrackChoice::simplify(double pixels) {
    if (const auto own = changeableBars(); !own.empty())
        change(tr("Simplify"), withFewKeys(design(), own, pixels * m_session.motion().pixel()));
}

void TrackChoice::remove() {
    if (const auto own = changeableKeys(); !own.empty())
        return changeKeys(own.size() > 1 ? tr("Remove keys") : tr("Remove key"), withoutKeys(design(), own));
    const auto own = changeableBars();
    if (own.empty()) return;
    if (m_bars.size() > 1) m_bars.clear();  // a single one is replaced by the next
    change(own.size() > 1 ? tr("Remove motions") : tr("Remove motion"), withoutMotions(design(), own));
}

void TrackChoice::hold(const std::vector<KeyId>& keys) {
    if (!keys.empty()) changeKeys(tr("Hold"), withKeysHeld(design(), keys));
}

std::vector<CopiedKey> TrackChoice::copiesOf(const std::vector<KeyId>& keys) const {
    return copiedKeys(design(), keys, keyStarts(m_session.pins()));
}

std::vector<CopiedKey> TrackChoice::mirrored(const std::vector<CopiedKey>& copies) const {
    const FramePtr frame = m_session.motion().frame();
    return frame ? mirroredKeys(*frame, design().handles, copies) : std::vector<CopiedKey>();
}

void TrackChoice::copy() {
    m_copied.clear();
    m_copiedFrom = m_session.document().generation();
    for (const CopiedKey& copy : copiesOf(m_keys.empty() ? endsOf(bars()) : keys()))
        m_copied.push_back({idOf(copy.handle), copy});
}

/// Sets copied poses, the first one at a time, in one undo step, and chooses the keys that there are now.
/// Locked pins stay; poses at the start of a pin's time, where it is at rest, are left out with a notice.
void TrackChoice::set(std::vector<CopiedKey> copies, double time, const QString& step) {
    Document& document = m_session.document();
    std::set<int> locked;
    for (const CopiedKey& copy : copies)
        if (!locked.contains(copy.handle) && !m_session.gestures().mayChange(copy.handle))
            locked.insert(copy.handle);
    std::erase_if(copies, [&](const CopiedKey& copy) { return locked.contains(copy.handle); });
    std::vector<KeyId> pasted;
    const auto next = withKeysPasted(*document.project(), copies, time, keyStarts(m_session.pins()), pasted);
    if (pasted.size() < copies.size())
        document.notify(ShapeSession::tr(
            "No pose was set where a pin begins, rotates or does not hold: show another time."));
    m_session.playback().setPlaying(false);
    if (!pasted.empty()) document.change(step, next);
    choose(pasted);
}

void TrackChoice::paste(double time, bool isMirrored) {
    std::vector<CopiedKey> copies;
    const bool isSameFile = m_copiedFrom == m_session.document().generation();
    for (auto [pin, copy] : m_copied) {
        if (isSameFile) copy.handle = placeOf(pin);
        if (copy.handle < m_session.pins().count()) copies.push_back(copy);
    }
    if (!isMirrored) copies = forPins(m_session.selection().handles(), copies);
    std::erase_if(copies, [](const CopiedKey& copy) { return copy.handle < 0; });
    if (isMirrored) copies = mirrored(copies);
    if (copies.empty()) return;
    set(std::move(copies), time, tr("Paste keys"));
    m_session.playback().setTime(time);
}

void TrackChoice::mirror() {
    const double first = std::ranges::min(m_keys, {}, &std::pair<Id, double>::second).second;
    set(mirrored(copiesOf(keys())), first, tr("Mirror keys"));
}

// --- Progress ---

std::vector<MotionId> TrackChoice::easedMotions() const {
    return m_keys.empty() ? changeableBars() : motionsBetween(design(), changeableKeys());
}

void TrackChoice::setProgress(const Progress& progress, const QString& by) {
    const auto motions = easedMotions();
    if (motions.empty()) return;
    m_session.playback().setPlaying(false);
    m_session.document().changeDesign(tr("Change easing"),
                                      withProgress(design(), motions, progress, keyStarts(m_session.pins())),
                                      by.isEmpty() ? by : stepName(by, motions));
}

void TrackChoice::holdEased() {
    std::vector<KeyId> starts;
    for (const MotionId& id : easedMotions())
        starts.push_back({id.handle, timeOf(design(), id.handle, id.motion).start});
    hold(starts);
}

}  // namespace wend
