#include "app/session/shape_gesture.h"

#include <algorithm>

#include "app/base/said.h"
#include "app/project/edits/film_time.h"
#include "app/project/edits/handle_edits.h"
#include "app/project/edits/pin_edits.h"
#include "app/project/edits/pose_edits.h"
#include "app/project/project.h"
#include "app/session/shape_session.h"
#include "core/motion/curve.h"

namespace wend {

namespace {

constexpr int kTickInterval = 20;  // milliseconds
constexpr int kCurveSteps = 24;    // samples per curve piece for its length
// Milliseconds between samples: an earlier one waits for the next, because frames beyond the screen's rate
// waste time. Shapes that take long to compute get every sample, so that they start with the newest.
constexpr double kPace = 12, kQuick = 25;  // milliseconds
constexpr int kLongestWait = 20;           // of a sample that none follows

/// Returns the path along a chain from its first point, sampled to measure its length.
std::vector<Amount> alongCurve(const std::vector<Vec3>& points) {
    std::vector<Amount> way = {Amount::Zero()};
    for (const auto& piece : bezierCurve<3>(points).pieces)
        for (int i = 1; i <= kCurveSteps; ++i)
            way.push_back(piece.value(double(i) / kCurveSteps) - points.front());
    return way;
}

/// Returns whether handles are of parts that a frame does not have.
bool lacksPart(const Document& document, const FramePtr& shown) {
    if (document.dimension() != 2 || !shown) return false;
    const std::vector<MeshPart>& parts = shown->parts();
    return std::ranges::any_of(document.design().handles, [&](const Pin& handle) {
        return !handle.part.empty() && std::ranges::find(parts, handle.part, &MeshPart::name) == parts.end();
    });
}

}  // namespace

ShapeGesture::ShapeGesture(Document& document, const Selection& selection, Playback& playback,
                           ShapeMotion& motion, const ShownPins& pins)
    : m_document(document), m_selection(selection), m_playback(playback), m_motion(motion), m_pins(pins) {
    m_goOn.setInterval(kTickInterval);
    connect(&m_goOn, &QTimer::timeout, this, &ShapeGesture::goOn);
    m_waits.setSingleShot(true);
    m_waits.setInterval(kLongestWait);
    connect(&m_waits, &QTimer::timeout, this, &ShapeGesture::lead);
    connect(&m_motion, &ShapeMotion::liveReady, this, &ShapeGesture::follow);
    connect(&m_motion, &ShapeMotion::dragMustEnd, this, &ShapeGesture::cancel);
    connect(&m_selection, &Selection::changed, this, &ShapeGesture::pinsChanged);
    connect(&m_document, &Document::projectChanged, this, [this] { emit stopped({}); });
}

double ShapeGesture::time() const {
    return m_drag ? m_from : m_playback.time();
}

std::vector<PinView> ShapeGesture::pins(bool all) const {
    std::vector<PinView> views = m_pins.at(time(), true, all);
    if (!m_drag) return views;
    const Amount amount = m_drag->amount();
    for (const PinView& start : m_grabbed)
        for (PinView& view : views) {
            if (view.handle != start.handle) continue;
            view = start;
            for (Vec3& p : view.points) p = carried(m_drag->grip(), amount, p);
            view.centre = carried(m_drag->grip(), amount, start.centre);
        }
    return views;
}

std::vector<int> ShapeGesture::unlocked(std::vector<int> handles) {
    std::vector<int> locked;
    for (const int h : handles)
        if (m_pins.isLocked(h)) locked.push_back(h);
    const bool isOwn = locked.size() == 1 && traitsOf(m_document.design(), locked.front()).locked;
    if (locked.size() == 1 && !isOwn)
        m_document.notify(ShapeSession::tr("%1 is in a part that is locked. The list of parts unlocks it.")
                              .arg(m_pins.nameOf(locked)));
    else if (isOwn)
        m_document.notify(ShapeSession::tr("%1 is locked. A right-click or the list of pins unlocks it.")
                              .arg(m_pins.nameOf(locked)));
    else if (!locked.empty())
        m_document.notify(ShapeSession::tr("%1 are locked. A right-click or the list of pins unlocks them.")
                              .arg(m_pins.nameOf(locked)));
    std::erase_if(handles, [&](int h) { return m_pins.isLocked(h); });
    return handles;
}

/// Returns the selected handles that act at the shown time, and those linked with them.
std::vector<int> ShapeGesture::movableHandles() {
    if (m_selection.isEmpty() || m_drag || !m_motion.frame()) return {};
    m_playback.setPlaying(false);
    std::vector<int> handles = m_selection.handles();
    const double time = m_motion.gestureTime();
    const auto keepHolding = [&] {
        const auto& all = m_document.design().handles;
        std::erase_if(handles, [&](int h) { return !isActive(all.at(h), time); });
    };
    keepHolding();
    if (handles.empty()) {
        m_document.notify(ShapeSession::tr("%1 does not hold the shape at the time shown.")
                              .arg(m_pins.nameOf(m_selection.handles())));
        return {};
    }
    handles = withLinked(m_document.design(), handles);
    keepHolding();
    return unlocked(std::move(handles));
}

/// Remembers where the handles are.
void ShapeGesture::takeHold(const std::vector<int>& handles) {
    m_grabbed = m_pins.at(time(), true, true);
    std::erase_if(m_grabbed, [&](const auto& view) {
        return std::find(handles.begin(), handles.end(), view.handle) == handles.end();
    });
}

void ShapeGesture::begin(const Grip& grip, bool records) {
    const auto handles = movableHandles();
    if (handles.empty()) return;
    if (m_motion.isMeshing() && lacksPart(m_document, m_motion.frame())) {
        m_document.notify(
            ShapeSession::tr("A part is still being made. Pins can be dragged as soon as it is there."));
        return;
    }
    takeHold(handles);
    m_from = m_motion.gestureTime();
    m_drag.emplace(handles, grip, records || m_records);
    m_isQuick = false;
    m_motion.beginDrag(handles, grip, m_from);
    m_sinceSample.start();
    if (m_drag->records()) m_goOn.start();
    emit began();
}

void ShapeGesture::moveBy(const Amount& amount, double seconds) {
    if (!m_drag) return;
    m_drag->add(amount, seconds);
    m_sinceSample.start();
    if (!m_isQuick || static_cast<double>(m_sinceLead.elapsed()) >= kPace)
        lead();
    else if (!m_waits.isActive())
        m_waits.start();
    emit moved(amount);
    emit pinsChanged();
}

/// Posts the newest sample to the compute thread.
void ShapeGesture::lead() {
    if (!m_drag) return;
    m_waits.stop();
    m_sinceLead.start();
    m_motion.dragTo(m_drag->newest(), m_drag->sampleCount(),
                    m_drag->records() ? std::optional(recordedTime()) : std::nullopt);
}

/// Returns the time of the recording in the film: that of the last sample plus the clock since then.
double ShapeGesture::recordedTime() const {
    const double seconds = m_drag->seconds() + 1e-3 * static_cast<double>(m_sinceSample.elapsed());
    return m_from + seconds * m_playback.speed() / Playback::kSecondsPerUnit;
}

/// Advances the other handles while recording, even if the pointer is still.
void ShapeGesture::goOn() {
    if (!m_drag) return;
    m_playback.setTime(recordedTime());
    if (movesAfter(m_document.design(), m_from) && m_drag->sampleCount() > 0) lead();
    emit pinsChanged();
}

void ShapeGesture::follow(const FramePtr& frame) {
    const bool wasStopped = m_drag->isStopped();
    m_isQuick = frame->milliseconds < kQuick;
    m_drag->follow(*frame);
    m_motion.showLive(frame);
    if (!m_drag || !frame->stopped) return;  // a slot of frameChanged() may have ended the drag
    m_stop = ShapeSession::tr("%1 cannot go further: %2")
                 .arg(m_pins.nameOf(m_drag->handles()), said(frame->message));
    if (!wasStopped) m_document.notify(m_stop);
}

void ShapeGesture::end(double tolerance) {
    if (!m_drag) return;
    if (!m_drag->records()) return end({m_drag->path(tolerance), {}});
    TimedPath path = m_drag->timedPath(tolerance);
    for (double& second : path.seconds) second *= m_playback.speed() / Playback::kSecondsPerUnit;
    end(path);
}

void ShapeGesture::endStraight() {
    if (m_drag) end({m_drag->straight(), {}});
}

void ShapeGesture::end(const TimedPath& path) {
    const DragGesture drag = *m_drag;
    if (path.points.size() < 2) {
        cancel();
    } else {
        letGo();
        if (!path.seconds.empty()) m_motion.dropPreview();  // the start of the motion is shown next
        push(drag, path, m_from);
    }
    if (drag.isStopped()) emit stopped(m_stop);
}

void ShapeGesture::letGo() {
    if (!m_drag) return;
    drop();
    m_motion.endDrag();
    emit ended();
}

void ShapeGesture::cancel() {
    if (!m_drag) return;
    if (m_drag->records()) m_playback.setTime(m_from);
    drop();
    m_motion.cancelDrag();
    emit cancelled();
    emit pinsChanged();
}

void ShapeGesture::drop() {
    m_drag.reset();
    m_goOn.stop();
    m_waits.stop();
}

void ShapeGesture::nudge(const Vec3& by) {
    const auto handles = movableHandles();
    if (handles.empty()) return;
    QString key = QStringLiteral("nudge");
    for (const int h : handles) key += QStringLiteral(" %1").arg(h);
    takeHold(handles);
    const DragGesture drag(handles, {});
    const double time = m_motion.gestureTime();
    const bool atTheEnd = takesTheEnd(*m_document.project(), time);
    if (m_poses &&
        motionEnd(*m_document.project()) > 0) {  // each step is a pose of its own, in one undo step
        const QString pose = QStringLiteral("pose ") + key + QStringLiteral(" %1").arg(time);
        return push(drag, {{Amount::Zero(), by}, {}}, time, pose);
    }
    // the first of several paths moves the playhead to the end
    const QString earlier = QStringLiteral("earlier ") + key;
    for (const QString& last : {key, earlier})
        if (atTheEnd && m_document.merges(last))
            return m_document.change(
                ShapeSession::tr("Move %1").arg(m_pins.nameOf(handles)),
                withLongerStroke(*m_document.project(), handles, by, armOf(drag), last == key), last);
    push(drag, {{Amount::Zero(), by}, {}}, time, atTheEnd ? key : earlier);
}

void ShapeGesture::moveAtOnce(const Grip& grip, const Amount& amount) {
    if (amount == Amount::Zero()) return;
    const auto handles = movableHandles();
    if (handles.empty()) return;
    takeHold(handles);
    push(DragGesture(handles, grip), {{Amount::Zero(), amount}, {}}, m_motion.gestureTime());
}

/// Keeps its own timing unless it is appended at the end, so that parallel motions continue.
void ShapeGesture::followCurve(const std::vector<Vec3>& points) {
    const auto handles = movableHandles();
    if (handles.empty()) return;
    takeHold(handles);
    TimedPath path{alongCurve(points), {}};
    const Project& project = *m_document.project();
    const double from = m_motion.gestureTime(), room = project.end - from;
    const auto pieces = static_cast<double>(path.points.size() - 1);
    if (motionEnd(project) == 0 || !takesTheEnd(project, from))
        for (std::size_t i = 0; i < path.points.size(); ++i)
            path.seconds.push_back(room * static_cast<double>(i) / pieces);
    std::vector<Amount> curve;
    for (const Vec3& p : points) curve.push_back(p - points.front());
    push(DragGesture(handles, {}), path, from, {}, curve);
}

/// Returns the mean distance of the handles from the gesture's centre: the lever arm of rotation and scaling.
double ShapeGesture::armOf(const DragGesture& drag) const {
    double sum = 0;
    int count = 0;
    const bool moves = drag.grip().kind == Grip::Kind::Move;
    for (const PinView& view : m_grabbed)
        for (const Vec3& p : view.points) {
            sum += (p - (moves ? view.centre : drag.grip().centre)).norm();
            ++count;
        }
    return std::max(sum / std::max(count, 1), m_motion.pixel());
}

void ShapeGesture::push(const DragGesture& drag, const TimedPath& path, double from, const QString& key,
                        const std::vector<Amount>& curve) {
    const bool records = !path.seconds.empty();
    const QString what = !curve.empty()                         ? ShapeSession::tr("Draw the path of %1")
                         : records                              ? ShapeSession::tr("Record %1")
                         : drag.grip().kind == Grip::Kind::Turn ? ShapeSession::tr("Rotate %1")
                         : drag.grip().kind == Grip::Kind::Grow ? ShapeSession::tr("Scale %1")
                                                                : ShapeSession::tr("Move %1");
    std::vector<Vec3> starts(drag.handles().size(), Vec3::Zero());
    for (const PinView& view : m_grabbed)
        for (std::size_t i = 0; i < starts.size(); ++i)
            if (drag.handles()[i] == view.handle) starts[i] = view.centre;
    const Project& project = *m_document.project();
    // An unreachable target that ended the motion early would stop this motion, too.
    const bool endsAll = !records && !m_motion.isBusy() && !m_motion.track().isEmpty() &&
                         m_motion.track().lastTime() <= from && !takesTheEnd(project, from);
    const Gesture gesture{drag.handles(), drag.grip(),  path.points, from,
                          armOf(drag),    path.seconds, curve,       endsAll};
    if (m_poses && !records && curve.empty() && motionEnd(project) > 0 &&
        pushPose(gesture, starts, what.arg(m_pins.nameOf(drag.handles())), key))
        return;
    const std::vector<Pin> before = m_document.design().handles;
    const bool lengthens = !records && takesTheEnd(project, from) && hasOwnTiming(project);
    m_document.change(what.arg(m_pins.nameOf(drag.handles())), withGesture(project, gesture, starts), key);
    // Recordings are shown by playing them, and others may be recorded at the same time.
    m_playback.setTime(records ? from : m_playback.end());
    const QString next = !records        ? QString()
                         : curve.empty() ? ShapeSession::tr(
                                               "Recorded. K plays it; record other pins from the same "
                                               "time, and they move together.")
                                         : ShapeSession::tr(
                                               "K plays it; draw the paths of other pins from the same "
                                               "time, and they move together.");
    tellReplaced(before, endsAll ? std::vector<int>() : drag.handles(), from, next);
    if (lengthens)
        m_document.notify(
            ShapeSession::tr("The film is longer by a second: what you had timed keeps its times."));
}

/// Returns false if the handles cannot be posed at that time. At the end of the film a drag makes it longer,
/// and a step of the arrow keys moves the last pose.
bool ShapeGesture::pushPose(const Gesture& gesture, const std::vector<Vec3>& starts, const QString& step,
                            const QString& key) {
    const Project& project = *m_document.project();
    const bool appends = key.isEmpty() && takesTheEnd(project, gesture.from);
    if (appends && !m_keepsWay && m_added == std::pair(gesture.handles, m_document.project()))
        if (const auto next = withLastMoveCorrected(project, gesture)) {
            m_document.change(step, *next);
            m_added.second = m_document.project();
            m_document.notify(
                ShapeSession::tr("The last move goes straight there now. Motion ▸ Keep the Path leads "
                                 "pins on instead."));
            return true;
        }
    const std::optional<Project> next =
        appends ? withPoseAppended(project, gesture, starts) : withPose(project, gesture, starts);
    if (!next) return false;
    if (const FramePtr& frame = m_motion.frame(); !appends && frame && frame->live) {
        m_motion.showLive(atTime(frame, gesture.from));  // until the exact shape of this time is known
        m_playback.setTime(gesture.from);
    }
    m_document.change(step, *next, key);
    if (appends) m_added = {gesture.handles, m_document.project()};
    m_playback.setTime(appends ? m_playback.end() : gesture.from);
    if (appends)
        m_document.notify(ShapeSession::tr(
            "The film is longer by a second. At an earlier time a drag sets the pose there."));
    else
        m_document.notify(ShapeSession::tr("Posed at %1 s: what comes before and after stays.")
                              .arg(gesture.from * Playback::kSecondsPerUnit, 0, 'f', 2));
    return true;
}

/// Tells that a gesture has replaced the later motion of its own handles or, if they have none, of all.
void ShapeGesture::tellReplaced(const std::vector<Pin>& before, const std::vector<int>& own, double from,
                                const QString& otherwise) {
    Design replaced;
    for (int h = 0; h < static_cast<int>(before.size()); ++h)
        if (own.empty() || std::count(own.begin(), own.end(), h)) replaced.handles.push_back(before[h]);
    if (!movesAfter(replaced, from)) {
        if (!otherwise.isEmpty()) m_document.notify(otherwise);
    } else if (own.empty()) {
        m_document.notify(ShapeSession::tr("This replaces what came after; Undo brings it back."));
    } else {
        m_document.notify(ShapeSession::tr("This replaces what %1 did later; Undo brings it back.")
                              .arg(m_pins.nameOf(own)));
    }
}

}  // namespace wend
