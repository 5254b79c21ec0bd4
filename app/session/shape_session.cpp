#include "app/session/shape_session.h"

#include <algorithm>

#include "app/document/handle_edits.h"
#include "app/session/fields.h"

namespace wend {

namespace {

/// The same shape, standing for another time.
FramePtr atTime(const FramePtr& frame, double time) {
    const auto copy = [time](const auto& own) -> FramePtr {
        auto other = std::make_shared<std::decay_t<decltype(own)>>(own);
        other->time = time;
        return other;
    };
    return frame->dimension == 2 ? copy(*posed<2>(frame)) : copy(*posed<3>(frame));
}

bool isIn(const FrameTrack& track, const FramePtr& frame) {
    const auto& frames = track.frames();
    return std::find(frames.begin(), frames.end(), frame) != frames.end();
}

}  // namespace

ShapeSession::ShapeSession(QObject* parent) : QObject(parent) {
    connect(&m_document, &Document::projectChanged, this, &ShapeSession::postShape);
    connect(&m_document, &Document::opened, this, &ShapeSession::reset);
    connect(&m_playback, &Playback::timeChanged, this, [this](double time) {
        if (m_drag) return;
        if (m_preview && m_preview->time != time) m_preview.reset();
        showTime();
    });
    connect(&m_playback, &Playback::playingChanged, this, &ShapeSession::askVelocity);
    connect(&m_selection, &Selection::changed, this, &ShapeSession::pinsChanged);
    connect(&m_compute, &ComputeThread::shapeReady, this, &ShapeSession::takeShape);
    connect(&m_compute, &ComputeThread::frameReady, this, &ShapeSession::takeFrame);
    connect(&m_compute, &ComputeThread::velocityReady, this, &ShapeSession::takeVelocity);
    connect(&m_compute, &ComputeThread::finished, this, &ShapeSession::takeFinished);
    connect(&m_compute, &ComputeThread::failed, this, &ShapeSession::takeFailure);
    connect(&m_compute, &ComputeThread::progress, this, &ShapeSession::progress);
}

/// For another file: what went on with the last one ends. First everything of it goes, only then others hear
/// of it: nobody sees the last file's shape, selection or drag beside the new one's project.
void ShapeSession::reset() {
    dropAll();
    m_selection.clear();
    m_playback.setPlaying(false);
    m_playback.setEnd(0);
    show({}, false);
    emit pinsChanged();
    if (m_document.isEmpty()) setBusy(false);
}

void ShapeSession::dropAll() {
    if (m_drag) m_compute.post(EndDrag{});
    if (m_document.isEmpty()) m_compute.post(CancelWork{});
    m_drag.reset();
    ++m_gesture;   // frames of a drag that are under way are void,
    ++m_revision;  // and so is a shape
    m_complete.reset();
    dropShape();
}

void ShapeSession::dropShape() {
    m_track.clear();
    m_frame.reset();
    m_preview.reset();
    m_previewBefore.reset();
    m_velocityOf.reset();
    m_askedFor.reset();
    m_velocity.reset();
    m_shape.reset();
    m_holds = {};
    m_trackIsCurrent = m_stale = m_sameShape = false;
}

void ShapeSession::postShape() {
    if (m_document.isEmpty()) return;
    cancelDrag();  // undo in the middle of it: its handles may be gone
    const double end = motionEnd(*m_document.project());
    if (m_preview && end < m_preview->time) m_preview.reset();
    const int count = handleCount();
    std::vector<int> kept = m_selection.handles();
    std::erase_if(kept, [count](int h) { return h >= count; });
    m_selection.set(std::move(kept));
    m_trackIsCurrent = false;
    m_sameShape = m_addsHandle && !m_stale;
    setBusy(true);
    m_compute.post(SetShape{{m_document.generation(), ++m_revision, m_document.project(),
                             m_document.picture(), m_document.folder().toStdString()}});
    m_playback.setEnd(end);
    showTime();
    emit pinsChanged();
}

void ShapeSession::takeShape(int revision, const std::shared_ptr<const void>& shape, double keptUpTo) {
    if (revision != m_revision) return;
    m_askedFor.reset();  // the question may have been dropped with the last shape
    m_velocityOf.reset();
    if (m_failed) emit problem({});
    m_failed = false;
    m_shape = shape;
    m_trackIsCurrent = true;
    m_track.cut(keptUpTo);
    m_playback.setReady(m_track.lastTime());
}

void ShapeSession::takeFrame(const FramePtr& frame) {
    if (frame->live) {
        if (frame->gesture == m_gesture) takeLive(frame);
        return;
    }
    if (frame->shape != m_shape) return;
    m_track.add(frame);
    m_playback.setReady(frame->time);
    if (!m_drag) showTime();
}

void ShapeSession::takeLive(const FramePtr& frame) {
    if (!m_drag) {
        if (!m_preview) return;
        m_preview = atTime(frame, m_preview->time);  // the tail of a drag that has just ended
        showTime();
        return;
    }
    const bool wasStopped = m_drag->isStopped();
    m_drag->follow(*frame);
    m_preview = frame;
    show(frame, false);
    if (m_drag && frame->stopped && !wasStopped)  // who sees the frame may have ended the drag
        emit notice(tr("%1 cannot go further: %2")
                        .arg(nameOf(m_drag->handles()), QString::fromStdString(frame->message)));
}

void ShapeSession::takeFinished(double time, const QString& problem) {
    if (!m_trackIsCurrent) return;
    m_complete = m_document.project();
    m_completeAt = m_document.undoStack()->index();
    if (!problem.isEmpty()) emit notice(tr("The motion stops at %1: %2").arg(time, 0, 'f', 2).arg(problem));
    m_preview.reset();
    m_previewBefore.reset();
    setBusy(false);
    if (!m_track.isEmpty()) m_playback.setReady(m_playback.end());
    showTime();
}

void ShapeSession::takeFailure(int revision, const QString& reason, bool shapeless) {
    if (revision != m_revision) return;  // of what is not wanted any more
    m_failed = true;
    cancelDrag();
    m_preview.reset();
    if (shapeless) {
        dropShape();
        show({}, false);
    }
    setBusy(false);
    emit problem(reason);
}

void ShapeSession::cancelWork() {
    if (!m_busy) return;
    cancelDrag();
    const bool meshing = isMeshing();
    if (m_complete && m_complete != m_document.project()) {
        goBack();
        emit notice(tr("Cancelled: everything is as it was before the last change."));
        return;
    }
    if (meshing) ++m_revision;  // a shape that is just ready comes too late
    m_compute.post(CancelWork{});
    m_preview.reset();
    setBusy(false);
    showTime();
    m_failed = meshing;
    if (meshing)
        emit problem(tr("Meshing was cancelled. Any change makes a mesh again, such as fewer vertices."));
    else
        emit notice(tr("The motion was cancelled. Any change computes it again."));
}

/// By undo steps if they lead there (and redo forth), otherwise by a change of its own: steps may have
/// merged.
void ShapeSession::goBack() {
    const auto target = m_complete;
    QUndoStack& undo = *m_document.undoStack();
    if (m_completeAt < undo.index()) undo.setIndex(m_completeAt);
    if (m_document.project() != target) m_document.change(tr("Cancel"), *target);
}

void ShapeSession::showTime() {
    if (m_drag) return;
    FramePtr frame = m_track.at(m_playback.time());
    const bool endedEarly = !frame && !m_busy && !m_track.isEmpty();
    if (endedEarly) frame = m_track.last();
    if (m_preview && (!frame || !m_trackIsCurrent))
        show(m_preview, false);
    else if (frame)
        show(frame, !m_trackIsCurrent && !m_sameShape);
    else if (m_trackIsCurrent && !m_track.isEmpty() && (!m_frame || isIn(m_track, m_frame)))
        show(m_track.last(), true);  // as far as it has come
    else
        show(m_frame, m_frame && !m_sameShape);
}

void ShapeSession::show(const FramePtr& frame, bool stale) {
    m_frame = frame;
    m_stale = stale;
    askVelocity();
    emit frameChanged();
}

void ShapeSession::setVelocityWanted(bool wanted) {
    m_velocityWanted = wanted;
    askVelocity();
}

void ShapeSession::askVelocity() {
    const bool stands = m_frame && !m_frame->live && !m_stale && !m_drag && !m_playback.isPlaying();
    if (!m_velocityWanted || !stands || !m_trackIsCurrent) return;
    if (m_velocityOf == m_frame || m_askedFor == m_frame || !isIn(m_track, m_frame)) return;
    m_askedFor = m_frame;
    m_compute.post(AskVelocity{m_frame, m_revision});
}

void ShapeSession::takeVelocity(const FramePtr& frame, const VelocityPtr& velocity) {
    m_velocityOf = frame;
    m_velocity = velocity;
    if (frame == m_frame) emit frameChanged();
}

template <int Dim>
Points<Dim> ShapeSession::velocity() const {
    if (hasVelocity() && m_velocity->rows() == Dim) return *m_velocity;
    const auto shown = frame<Dim>();
    return shown ? velocityBetween<Dim>(m_track, *shown) : Points<Dim>(Dim, 0);
}

void ShapeSession::setBusy(bool busy) {
    if (busy == m_busy) return;
    m_busy = busy;
    emit busyChanged(busy);
}

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
    const double time = m_drag ? motionEnd(*m_document.project()) : m_playback.time();
    return viewPins<Dim>(m_document.design<Dim>().handles, places<Dim>(), *shape->rest, shape->pose, time,
                         holding);
}

template <int Dim>
std::vector<PinView<Dim>> ShapeSession::ghosts() const {
    return views<Dim>(false);
}

template <int Dim>
std::vector<PinView<Dim>> ShapeSession::pins() const {
    auto views = this->views<Dim>(true);
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

double ShapeSession::pixel() const {
    return m_document.picture() || !m_frame ? 1 : m_frame->diagonal / 2000;
}

template <int Dim>
int ShapeSession::addPin(const Vec<Dim>& p) {
    if (!m_frame || m_document.dimension() != Dim) return -1;
    const auto shape = frame<Dim>();
    const auto rest = shape ? restPoint<Dim>(*shape->rest, shape->pose, p) : std::nullopt;
    if (!rest) emit notice(tr("There is no pin: this place lies outside of the shape."));
    return rest ? addHandle<Dim>(std::vector<Vec<Dim>>{*rest}, "Pin") : -1;
}

template <int Dim>
int ShapeSession::addHandle(Placement<Dim> at, const std::string& kind) {
    if (!m_frame || m_document.dimension() != Dim) return -1;
    goToEnd();
    m_addsHandle = true;
    const std::string name = freePinName(m_document.design<Dim>(), kind);
    m_document.change(tr("Add %1").arg(QString::fromStdString(name)),
                      withHandle<Dim>(*m_document.project(), std::move(at), name));
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
    const auto handles = m_selection.handles();
    const QString name = tr("Remove %1").arg(nameOf(handles));
    m_selection.clear();
    m_document.change(name, withoutHandles(*m_document.project(), handles));
}

template <int Dim>
void ShapeSession::nudgeSelected(const Vec<Dim>& by) {
    const auto handles = movableHandles();
    if (handles.empty()) return;
    QString key = QStringLiteral("nudge");
    for (const int h : handles) key += QStringLiteral(" %1").arg(h);
    const Project& project = *m_document.project();
    m_document.change(tr("Move %1").arg(nameOf(handles)),
                      m_document.merges(key) ? withLongerStroke<Dim>(project, handles, by)
                                             : withStroke<Dim>(project, handles, centresOf<Dim>(handles),
                                                               {Vec<Dim>::Zero(), by}),
                      key);
}

template <int Dim>
void ShapeSession::moveSelected(const Grip& grip, const Amount& amount) {
    if (amount == Amount::Zero()) return;
    const auto handles = movableHandles();
    if (handles.empty()) return;
    takeHold<Dim>(handles);
    pushGesture<Dim>(DragGesture(handles, grip), {Amount::Zero(), amount});
}

/// The selected handles that hold the shape at the end, where gestures go on; goes there.
std::vector<int> ShapeSession::movableHandles() {
    if (m_selection.isEmpty() || m_drag || !m_frame) return {};
    goToEnd();
    std::vector<int> handles = m_selection.handles();
    const double end = motionEnd(*m_document.project());
    std::visit(
        [&](const auto& design) {
            std::erase_if(handles, [&](int h) { return !isActive(design.handles.at(h), end); });
        },
        m_document.project()->design);
    if (handles.empty())
        emit notice(tr("%1 does not hold the shape at the end any more.").arg(nameOf(m_selection.handles())));
    return handles;
}

/// Remembers where the handles are.
template <int Dim>
void ShapeSession::takeHold(const std::vector<int>& handles) {
    auto& grabbed = std::get<Hold<Dim>>(m_holds).grabbed;
    grabbed = pins<Dim>();
    std::erase_if(grabbed, [&](const auto& view) {
        return std::find(handles.begin(), handles.end(), view.handle) == handles.end();
    });
}

void ShapeSession::beginDrag(const Grip& grip) {
    m_playback.setPlaying(false);
    const auto handles = movableHandles();
    if (handles.empty()) return;
    if (m_frame->dimension == 2)
        takeHold<2>(handles);
    else
        takeHold<3>(handles);
    m_previewBefore = m_preview;
    m_drag.emplace(handles, grip);
    m_compute.post(BeginDrag{handles, grip, ++m_gesture, m_revision, m_frame});
}

void ShapeSession::dragBy(const Amount& amount) {
    if (!m_drag) return;
    const int sample = m_drag->add(amount);
    m_compute.post(DragTo{amount, sample});
    emit pinsChanged();
}

template <int Dim>
void ShapeSession::pushGesture(const DragGesture& drag, const std::vector<Amount>& path) {
    const QString what = drag.grip().kind == Grip::Kind::Turn   ? tr("Turn %1")
                         : drag.grip().kind == Grip::Kind::Grow ? tr("Scale %1")
                                                                : tr("Move %1");
    std::vector<Vec<Dim>> starts;
    for (const auto& view : std::get<Hold<Dim>>(m_holds).grabbed) starts.push_back(view.centre);
    m_document.change(what.arg(nameOf(drag.handles())),
                      withGesture<Dim>(*m_document.project(), drag.handles(), starts, drag.grip(), path));
}

void ShapeSession::endDrag(double tolerance) {
    if (m_drag) endDrag(m_drag->path(tolerance));
}

void ShapeSession::endDragStraight() {
    if (m_drag) endDrag(m_drag->straight());
}

void ShapeSession::endDrag(const std::vector<Amount>& path) {
    const DragGesture drag = std::move(*m_drag);
    m_drag.reset();
    m_compute.post(EndDrag{});
    if (path.size() < 2) {
        m_preview = m_previewBefore;
        showTime();
        return;
    }
    // From now on it stands for the end of the longer motion; its last frames may be yet to come.
    m_preview = atTime(m_preview ? m_preview : m_frame, motionEnd(*m_document.project()) + 1);
    if (m_document.dimension() == 2)
        pushGesture<2>(drag, path);
    else
        pushGesture<3>(drag, path);
}

void ShapeSession::cancelDrag() {
    if (!m_drag) return;
    m_drag.reset();
    m_preview = m_previewBefore;
    ++m_gesture;  // frames of it that are under way are void
    m_compute.post(EndDrag{});
    showTime();
    emit pinsChanged();
}

void ShapeSession::goToEnd() {
    m_playback.setTime(m_playback.end());
}

template <int Dim>
std::vector<Vec<Dim>> ShapeSession::centresOf(const std::vector<int>& handles) const {
    std::vector<Vec<Dim>> centres;
    const auto views = pins<Dim>();
    for (const int h : handles) {
        const auto it =
            std::find_if(views.begin(), views.end(), [h](const auto& view) { return view.handle == h; });
        centres.push_back(it == views.end() ? Vec<Dim>(Vec<Dim>::Zero()) : it->centre);
    }
    return centres;
}

QString ShapeSession::nameOf(const std::vector<int>& handles) const {
    if (handles.size() != 1) return tr("%n pins", nullptr, static_cast<int>(handles.size()));
    return QString::fromStdString(
        std::visit([&](const auto& design) { return design.handles.at(handles[0]).name; },
                   m_document.project()->design));
}

#define WEND_INSTANTIATE(Dim)                                                      \
    template Points<Dim> ShapeSession::velocity<Dim>() const;                      \
    template std::vector<PinView<Dim>> ShapeSession::pins<Dim>() const;            \
    template std::vector<PinView<Dim>> ShapeSession::ghosts<Dim>() const;          \
    template std::vector<Vec<Dim>> ShapeSession::pathStarts<Dim>(int) const;       \
    template int ShapeSession::addPin<Dim>(const Vec<Dim>&);                       \
    template int ShapeSession::addHandle<Dim>(Placement<Dim>, const std::string&); \
    template void ShapeSession::nudgeSelected<Dim>(const Vec<Dim>&);               \
    template void ShapeSession::moveSelected<Dim>(const Grip&, const Amount&)

WEND_INSTANTIATE(2);
WEND_INSTANTIATE(3);
#undef WEND_INSTANTIATE

}  // namespace wend
