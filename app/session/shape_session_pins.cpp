// Pins: where they are, how they come and go, and how they are dragged.
#include <algorithm>

#include "app/document/handle_edits.h"
#include "app/document/pin_edits.h"
#include "app/session/shape_session.h"

namespace wend {

template <int Dim>
const std::vector<PinPlace<Dim>>& ShapeSession::places() const {
    auto& hold = std::get<Hold<Dim>>(m_holds);
    const auto shape = frame<Dim>();
    if (hold.rest != shape->rest || hold.project != m_document.project()) {
        const PointLocator<Dim> locator(shape->rest->points, shape->rest->cells);
        hold.rest = shape->rest;
        hold.project = m_document.project();
        hold.places = placePins<Dim>(m_document.design<Dim>().handles, *shape->rest, locator);
    }
    return hold.places;
}

int ShapeSession::handleCount() const {
    return static_cast<int>(
        std::visit([](const auto& design) { return design.handles.size(); }, m_document.project()->design));
}

int ShapeSession::singleHandle() const {
    const auto& selected = m_selection.handles();
    if (m_document.isEmpty() || selected.size() != 1) return -1;
    return selected.front() < handleCount() ? selected.front() : -1;
}

template <int Dim>
std::vector<PinView<Dim>> ShapeSession::views(bool holding) const {
    const auto shape = frame<Dim>();
    if (!shape || m_document.dimension() != Dim) return {};
    const double time = m_drag ? m_dragFrom : m_playback.time();
    return viewPins<Dim>(m_document.design<Dim>().handles, places<Dim>(), *shape->rest, shape->pose, time,
                         holding);
}

/// What is to be seen of handles.
template <int Dim>
std::vector<PinView<Dim>> ShapeSession::shown(std::vector<PinView<Dim>> views) const {
    std::erase_if(views, [this](const PinView<Dim>& view) {
        return m_document.design<Dim>().handles[view.handle].traits.hidden;
    });
    return views;
}

template <int Dim>
std::vector<PinView<Dim>> ShapeSession::ghosts() const {
    return shown<Dim>(views<Dim>(false));
}

template <int Dim>
std::vector<PinView<Dim>> ShapeSession::pins(bool all) const {
    auto views = all ? this->views<Dim>(true) : shown<Dim>(this->views<Dim>(true));
    if (!m_drag) return views;
    // The handle follows at once, the shape catches up.
    const Amount amount = m_drag->amount();
    for (const PinView<Dim>& start : std::get<Hold<Dim>>(m_holds).grabbed)
        for (PinView<Dim>& view : views) {
            if (view.handle != start.handle) continue;
            view = start;
            for (Vec<Dim>& p : view.points) p = carried<Dim>(m_drag->grip(), amount, p);
            view.centre = carried<Dim>(m_drag->grip(), amount, start.centre);
        }
    return views;
}

template <int Dim>
std::vector<Vec<Dim>> ShapeSession::pathStarts(int handle) const {
    std::vector<Vec<Dim>> starts;
    const auto shown = frame<Dim>();
    if (!shown || m_document.dimension() != Dim) return starts;
    const double from = m_document.design<Dim>().handles.at(handle).activeFrom;
    const auto first = posed<Dim>(from > 0 ? m_track.at(from) : FramePtr());
    const SimplicialMesh<Dim>& rest = *shown->rest;
    const Points<Dim>& pose = first && first->rest == shown->rest ? first->pose : rest.points;
    for (const auto& location : places<Dim>()[handle].points)
        starts.push_back(positionOf<Dim>(location, rest, pose));
    return starts;
}

/// Of a motion that has ended early, its end.
double ShapeSession::gestureTime() const {
    if (m_document.isEmpty()) return 0;
    const double end = motionEnd(*m_document.project());
    const bool endedEarly = m_trackIsCurrent && !m_busy && !m_track.isEmpty() && m_track.lastTime() < end;
    const bool scrubbed = m_frame && !m_stale && !m_frame->live && m_playback.time() < end;
    if (endedEarly || scrubbed) return std::min(m_frame->time, end);
    return std::min(m_playback.time(), end);
}

double ShapeSession::pixel() const {
    return m_document.picture() || !m_frame ? 1 : m_frame->diagonal / 2000;
}

template <int Dim>
int ShapeSession::addPin(const Vec<Dim>& p) {
    if (!m_frame || m_document.dimension() != Dim) return -1;
    const auto shape = frame<Dim>();
    const PointLocator<Dim> locator(shape->pose, shape->rest->cells);
    return addPin<Dim>(locator.find(p));
}

template <int Dim>
int ShapeSession::addPin(const std::optional<Location<Dim>>& place) {
    const auto shape = frame<Dim>();
    if (!place) emit notice(tr("There is no pin: this place lies outside of the shape."));
    if (!place || !shape) return -1;
    return addHandle<Dim>(std::vector<Vec<Dim>>{positionOf<Dim>(*place, *shape->rest, shape->rest->points)},
                          "Pin");
}

template <int Dim>
int ShapeSession::addHandle(Placement<Dim> at, const std::string& kind) {
    if (!m_frame || m_document.dimension() != Dim) return -1;
    m_playback.setPlaying(false);
    const double time = gestureTime();
    m_playback.setTime(time);  // that of the picture that is shown
    m_addsHandle = true;
    const std::string name = freePinName(m_document.design<Dim>(), kind);
    m_document.change(tr("Add %1").arg(QString::fromStdString(name)),
                      withHandle<Dim>(*m_document.project(), std::move(at), name, time));
    m_addsHandle = false;
    const int handle = handleCount() - 1;
    m_selection.set({handle});
    return handle;
}

Placement<3> ShapeSession::placementOf(const std::vector<int>& vertices) const {
    const auto shape = frame<3>();
    if (!shape || m_document.project()->domain.kind == DomainKind::Mesh) return vertices;
    std::vector<Vec<3>> points;
    points.reserve(vertices.size());
    for (const int v : vertices) points.push_back(shape->rest->points.col(v));
    return points;
}

int ShapeSession::addSolidHandle(const std::vector<int>& vertices, const std::string& kind) {
    return vertices.empty() ? -1 : addHandle<3>(placementOf(vertices), kind);
}

void ShapeSession::changeHandle(int handle, const std::vector<int>& vertices) {
    if (!mayChange(handle)) return;
    m_document.change(tr("Change %1").arg(nameOf({handle})),
                      withHandlePlace<3>(*m_document.project(), handle, placementOf(vertices)));
}

std::vector<int> ShapeSession::verticesOf(int handle) const {
    const auto shape = frame<3>();
    std::vector<int> vertices;
    if (!shape) return vertices;
    for (const auto& location : places<3>()[handle].points) {
        int corner = 0;
        location.weights.maxCoeff(&corner);
        vertices.push_back(shape->rest->cells[location.cell][corner]);
    }
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    return vertices;
}

void ShapeSession::removeSelected() {
    if (m_selection.isEmpty() || m_drag) return;
    const auto handles = unlocked(m_selection.handles());
    if (handles.empty()) return;
    const QString name = tr("Remove %1").arg(nameOf(handles));
    m_playback.setPlaying(false);
    const double time = gestureTime();
    m_selection.clear();
    m_document.change(name, withoutHandles(*m_document.project(), handles, time));
}

template <int Dim>
void ShapeSession::nudgeSelected(const Vec<Dim>& by) {
    const auto handles = movableHandles();
    if (handles.empty()) return;
    QString key = QStringLiteral("nudge");
    for (const int h : handles) key += QStringLiteral(" %1").arg(h);
    takeHold<Dim>(handles);
    const DragGesture drag(handles, {});
    if (gestureTime() >= m_playback.end() && m_document.merges(key))
        m_document.change(tr("Move %1").arg(nameOf(handles)),
                          withLongerStroke<Dim>(*m_document.project(), handles, by, armOf<Dim>(drag)), key);
    else
        pushGesture<Dim>(drag, {{Amount::Zero(), amountOf<Dim>(by)}, {}}, gestureTime(), key);
}

template <int Dim>
void ShapeSession::moveSelected(const Grip& grip, const Amount& amount) {
    if (amount == Amount::Zero()) return;
    const auto handles = movableHandles();
    if (handles.empty()) return;
    takeHold<Dim>(handles);
    pushGesture<Dim>(DragGesture(handles, grip), {{Amount::Zero(), amount}, {}}, gestureTime());
}

/// The selected handles that hold the shape at the time that is shown, with those that go along.
std::vector<int> ShapeSession::movableHandles() {
    if (m_selection.isEmpty() || m_drag || !m_frame) return {};
    m_playback.setPlaying(false);
    std::vector<int> handles = m_selection.handles();
    const double time = gestureTime();
    const auto keepHolding = [&] {
        std::visit(
            [&](const auto& design) {
                std::erase_if(handles, [&](int h) { return !isActive(design.handles.at(h), time); });
            },
            m_document.project()->design);
    };
    keepHolding();
    if (handles.empty()) {
        emit notice(
            tr("%1 does not hold the shape at the time that is shown.").arg(nameOf(m_selection.handles())));
        return {};
    }
    handles = withLinked(*m_document.project(), handles);
    keepHolding();
    return unlocked(std::move(handles));
}

/// Those that may be changed; who stays is told.
std::vector<int> ShapeSession::unlocked(std::vector<int> handles) {
    std::vector<int> locked;
    for (const int h : handles)
        if (traitsOf(*m_document.project(), h).locked) locked.push_back(h);
    if (locked.size() == 1)
        emit notice(tr("%1 is locked. A right click or the list of pins unlocks it.").arg(nameOf(locked)));
    else if (!locked.empty())
        emit notice(tr("%1 are locked. A right click or the list of pins unlocks them.").arg(nameOf(locked)));
    std::erase_if(handles, [&](int h) { return traitsOf(*m_document.project(), h).locked; });
    return handles;
}

/// Remembers where the handles are.
template <int Dim>
void ShapeSession::takeHold(const std::vector<int>& handles) {
    auto& grabbed = std::get<Hold<Dim>>(m_holds).grabbed;
    grabbed = pins<Dim>(true);
    std::erase_if(grabbed, [&](const auto& view) {
        return std::find(handles.begin(), handles.end(), view.handle) == handles.end();
    });
}

void ShapeSession::beginDrag(const Grip& grip, bool records) {
    const auto handles = movableHandles();
    if (handles.empty()) return;
    if (m_frame->dimension == 2)
        takeHold<2>(handles);
    else
        takeHold<3>(handles);
    m_previewBefore = m_preview;
    m_dragFrom = gestureTime();
    m_drag.emplace(handles, grip, records || m_records);
    m_compute.post(BeginDrag{handles, grip, ++m_gesture, m_revision, m_frame, m_dragFrom});
    m_sinceSample.start();
    if (m_drag->records()) m_goOn.start();
    emit dragBegan();
}

void ShapeSession::dragBy(const Amount& amount, double seconds) {
    if (!m_drag) return;
    const int sample = m_drag->add(amount, seconds);
    m_sinceSample.start();
    const bool records = m_drag->records();
    m_compute.post(DragTo{amount, sample, records ? std::optional(recordedTime()) : std::nullopt});
    emit dragMoved(amount);
    emit pinsChanged();
}

/// Of the film: when the recording is, by the last sample and the clock since then.
double ShapeSession::recordedTime() const {
    const double seconds = m_drag->seconds() + 1e-3 * static_cast<double>(m_sinceSample.elapsed());
    return m_dragFrom + seconds * m_playback.speed() / Playback::kSecondsPerUnit;
}

/// The hand rests, the others go on.
void ShapeSession::goOn() {
    if (!m_drag) return;
    m_playback.setTime(recordedTime());
    const bool moves = std::visit([this](const auto& d) { return movesAfter(d, m_dragFrom); },
                                  m_document.project()->design);
    if (moves && m_drag->sampleCount() > 0)
        m_compute.post(DragTo{m_drag->newest(), m_drag->sampleCount(), recordedTime()});
    emit pinsChanged();
}

/// How far from the middle of a gesture what it turns or grows lies, in the mean.
template <int Dim>
double ShapeSession::armOf(const DragGesture& drag) const {
    double sum = 0;
    int count = 0;
    const bool moves = drag.grip().kind == Grip::Kind::Move;
    for (const auto& view : std::get<Hold<Dim>>(m_holds).grabbed)
        for (const Vec<Dim>& p : view.points) {
            sum += (p - (moves ? view.centre : Vec<Dim>(drag.grip().centre.template head<Dim>()))).norm();
            ++count;
        }
    return std::max(sum / std::max(count, 1), pixel());
}

template <int Dim>
void ShapeSession::pushGesture(const DragGesture& drag, const TimedPath& path, double from,
                               const QString& key) {
    const bool records = !path.seconds.empty();
    const QString what = records                                ? tr("Record %1")
                         : drag.grip().kind == Grip::Kind::Turn   ? tr("Turn %1")
                         : drag.grip().kind == Grip::Kind::Grow ? tr("Scale %1")
                                                                : tr("Move %1");
    std::vector<Vec<Dim>> starts(drag.handles().size(), Vec<Dim>::Zero());
    for (const auto& view : std::get<Hold<Dim>>(m_holds).grabbed)
        for (std::size_t i = 0; i < starts.size(); ++i)
            if (drag.handles()[i] == view.handle) starts[i] = view.centre;
    const Gesture gesture{drag.handles(), drag.grip(), path.points, from, armOf<Dim>(drag), path.seconds};
    const std::vector<Handle<Dim>> before = m_document.design<Dim>().handles;
    m_document.change(what.arg(nameOf(drag.handles())),
                      withGesture<Dim>(*m_document.project(), gesture, starts), key);
    // What was recorded is seen by playing it, and others may be recorded to it.
    m_playback.setTime(records ? from : m_playback.end());
    tellReplaced<Dim>(before, records ? drag.handles() : std::vector<int>(), from);
}

/// A recording replaces what its own handles did, any other gesture (of none) what all did.
template <int Dim>
void ShapeSession::tellReplaced(const std::vector<Handle<Dim>>& before, const std::vector<int>& recorded,
                                double from) {
    Design<Dim> replaced;
    for (int h = 0; h < static_cast<int>(before.size()); ++h)
        if (recorded.empty() || std::count(recorded.begin(), recorded.end(), h))
            replaced.handles.push_back(before[h]);
    if (movesAfter<Dim>(replaced, from))
        emit notice(tr("What came after is replaced by this; Undo brings it back."));
    else if (!recorded.empty())
        emit notice(tr("Recorded. K plays it; record other pins from the same time, and they move together."));
}

void ShapeSession::endDrag(double tolerance) {
    if (!m_drag) return;
    if (!m_drag->records()) return endDrag({m_drag->path(tolerance), {}});
    TimedPath path = m_drag->timedPath(tolerance);
    for (double& second : path.seconds) second *= m_playback.speed() / Playback::kSecondsPerUnit;
    endDrag(path);
}

void ShapeSession::endDragStraight() {
    if (m_drag) endDrag({m_drag->straight(), {}});
}

void ShapeSession::endDrag(const TimedPath& path) {
    if (path.points.size() < 2) {
        cancelDrag();
        return;
    }
    const DragGesture drag = *m_drag;
    letGo();
    if (!path.seconds.empty()) m_preview.reset();  // what is shown next is its beginning
    if (m_document.dimension() == 2)
        pushGesture<2>(drag, path, m_dragFrom);
    else
        pushGesture<3>(drag, path, m_dragFrom);
}

/// Its last frames may be yet to come.
void ShapeSession::letGo() {
    if (!m_drag) return;
    m_drag.reset();
    m_goOn.stop();
    m_compute.post(EndDrag{});
    m_preview = atTime(m_preview ? m_preview : m_frame, m_document.project()->end);
    emit dragEnded();
}

void ShapeSession::cancelDrag() {
    if (!m_drag) return;
    if (m_drag->records()) m_playback.setTime(m_dragFrom);
    m_drag.reset();
    m_goOn.stop();
    m_preview = m_previewBefore;
    ++m_gesture;  // frames of it that are under way are void
    m_compute.post(EndDrag{});
    emit dragCancelled();
    showTime();
    emit pinsChanged();
}

QString ShapeSession::nameOf(const std::vector<int>& handles) const {
    if (handles.size() != 1) return tr("%n pins", nullptr, static_cast<int>(handles.size()));
    return QString::fromStdString(
        std::visit([&](const auto& design) { return design.handles.at(handles[0]).name; },
                   m_document.project()->design));
}

#define WEND_INSTANTIATE(Dim)                                                      \
    template std::vector<PinView<Dim>> ShapeSession::pins<Dim>(bool) const;        \
    template std::vector<PinView<Dim>> ShapeSession::ghosts<Dim>() const;          \
    template std::vector<Vec<Dim>> ShapeSession::pathStarts<Dim>(int) const;       \
    template int ShapeSession::addPin<Dim>(const Vec<Dim>&);                       \
    template int ShapeSession::addPin<Dim>(const std::optional<Location<Dim>>&);   \
    template int ShapeSession::addHandle<Dim>(Placement<Dim>, const std::string&); \
    template void ShapeSession::nudgeSelected<Dim>(const Vec<Dim>&);               \
    template void ShapeSession::moveSelected<Dim>(const Grip&, const Amount&)

WEND_INSTANTIATE(2);
WEND_INSTANTIATE(3);
#undef WEND_INSTANTIATE

}  // namespace wend
