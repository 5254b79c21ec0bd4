#include "app/session/shape_session.h"

#include <algorithm>

#include "app/document/handle_edits.h"

namespace wend {

ShapeSession::ShapeSession(QObject* parent) : QObject(parent) {
    connect(&m_document, &Document::projectChanged, this, &ShapeSession::postShape);
    connect(&m_document, &Document::opened, this, [this] {
        m_track.clear();
        m_rest.reset();
        m_placed = {};
        m_preview.reset();
        m_drag.reset();
        m_selection.clear();
        m_playback.setPlaying(false);
        m_playback.setEnd(0);
        show({}, false);
    });
    connect(&m_playback, &Playback::timeChanged, this, [this](double time) {
        if (m_drag) return;
        if (m_preview && m_preview->time != time) m_preview.reset();
        showTime();
    });
    connect(&m_selection, &Selection::changed, this, &ShapeSession::pinsChanged);
    connect(&m_compute, &ComputeThread::shapeReady, this, &ShapeSession::takeShape);
    connect(&m_compute, &ComputeThread::frameReady, this, &ShapeSession::takeFrame);
    connect(&m_compute, &ComputeThread::finished, this, &ShapeSession::takeFinished);
    connect(&m_compute, &ComputeThread::failed, this, &ShapeSession::takeFailure);
    connect(&m_compute, &ComputeThread::progress, this, &ShapeSession::progress);
}

void ShapeSession::postShape() {
    if (m_document.isEmpty()) return;
    const double end = motionEnd(*m_document.project());
    if (m_preview && end < m_preview->time) m_preview.reset();
    const int count = static_cast<int>(m_document.design().handles.size());
    std::vector<int> kept = m_selection.handles();
    std::erase_if(kept, [count](int h) { return h >= count; });
    m_selection.set(std::move(kept));
    m_trackIsCurrent = false;
    setBusy(true);
    m_compute.post(SetShape{{m_document.generation(), ++m_revision, m_document.project(),
                             m_document.picture(), m_document.folder().toStdString()}});
    m_playback.setEnd(end);
    showTime();
    emit pinsChanged();
}

void ShapeSession::takeShape(int revision, const std::shared_ptr<const SimplicialMesh<2>>& rest,
                             double keptUpTo) {
    if (revision != m_revision) return;
    if (m_failed) emit problem({});
    m_failed = false;
    m_rest = rest;
    m_trackIsCurrent = true;
    m_track.cut(keptUpTo);
    m_playback.setReady(m_track.lastTime());
}

void ShapeSession::takeFrame(const FramePtr& frame) {
    if (frame->rest != m_rest) return;
    if (frame->live) {
        takeLive(frame);
        return;
    }
    m_track.add(frame);
    m_playback.setReady(frame->time);
    if (!m_drag) showTime();
}

void ShapeSession::takeLive(const FramePtr& frame) {
    if (!m_drag) {
        if (m_preview) m_preview = frame;  // the tail of a drag that has just ended
        return;
    }
    const bool wasStopped = m_drag->isStopped();
    m_drag->follow(*frame);
    m_preview = frame;
    show(frame, false);
    if (frame->stopped && !wasStopped)
        emit notice(tr("%1 cannot go further: the shape would fold over. %2")
                        .arg(nameOf(m_drag->handles()), QString::fromStdString(frame->message)));
}

void ShapeSession::takeFinished(double time, const QString& problem) {
    if (!m_trackIsCurrent) return;
    if (!problem.isEmpty()) emit notice(tr("The motion stops at %1: %2").arg(time, 0, 'f', 2).arg(problem));
    m_preview.reset();
    setBusy(false);
    if (!m_track.isEmpty()) m_playback.setReady(m_playback.end());
    showTime();
}

void ShapeSession::takeFailure(const QString& reason) {
    m_failed = true;
    m_preview.reset();
    setBusy(false);
    cancelDrag();
    emit problem(reason);
}

void ShapeSession::showTime() {
    if (m_drag) return;
    FramePtr frame = m_track.at(m_playback.time());
    const bool endedEarly = !frame && !m_busy && !m_track.isEmpty();
    if (endedEarly) frame = m_track.last();
    if (m_preview && (!frame || !m_trackIsCurrent))
        show(m_preview, false);
    else if (frame)
        show(frame, !m_trackIsCurrent);
    else
        show(m_frame, m_frame != nullptr);
}

void ShapeSession::show(const FramePtr& frame, bool stale) {
    m_frame = frame;
    m_stale = stale;
    emit frameChanged();
}

void ShapeSession::setBusy(bool busy) {
    if (busy == m_busy) return;
    m_busy = busy;
    emit busyChanged(busy);
}

const std::vector<PinPlace>& ShapeSession::places() const {
    if (m_placed.rest != m_frame->rest || m_placed.project != m_document.project()) {
        const PointLocator<2> locator(m_frame->rest->points, m_frame->rest->cells);
        m_placed = {m_frame->rest, m_document.project(),
                    placePins(m_document.design().handles, *m_frame->rest, locator)};
    }
    return m_placed.places;
}

std::vector<PinView> ShapeSession::pins() const {
    if (!m_frame || m_document.isEmpty()) return {};
    const double time = m_drag ? motionEnd(*m_document.project()) : m_playback.time();
    auto views = viewPins(m_document.design().handles, places(), *m_frame->rest, m_frame->pose, time);
    if (!m_drag) return views;
    for (PinView& view : views) {
        const auto& dragged = m_drag->handles();
        const auto it = std::find(dragged.begin(), dragged.end(), view.handle);
        if (it == dragged.end()) continue;
        const Vec<2> shift = m_drag->starts()[it - dragged.begin()] + m_drag->offset() - view.centre;
        for (Vec<2>& p : view.points) p += shift;
        view.centre += shift;
    }
    return views;
}

std::vector<Vec<2>> ShapeSession::pathStarts(int handle) const {
    std::vector<Vec<2>> starts;
    if (!m_frame || m_document.isEmpty()) return starts;
    const double from = m_document.design().handles[handle].activeFrom;
    const FramePtr frame = from > 0 ? m_track.at(from) : FramePtr();
    const SimplicialMesh<2>& rest = *m_frame->rest;
    const Points<2>& pose = frame && frame->rest == m_frame->rest ? frame->pose : rest.points;
    for (const auto& location : places()[handle].points) starts.push_back(positionOf(location, rest, pose));
    return starts;
}

double ShapeSession::pixel() const {
    if (m_document.picture() || !m_rest) return 1;
    return boundingBoxDiagonal<2>(m_rest->points) / 2000;
}

int ShapeSession::addPin(const Vec<2>& p) {
    if (!m_frame || m_document.isEmpty()) return -1;
    goToEnd();
    const auto rest = restPoint(*m_frame->rest, m_frame->pose, p);
    if (!rest) return -1;
    const Project& project = *m_document.project();
    const std::string name = freePinName(m_document.design());
    m_document.change(tr("Add %1").arg(QString::fromStdString(name)), withPin(project, *rest, name));
    const int handle = static_cast<int>(m_document.design().handles.size()) - 1;
    m_selection.set({handle});
    return handle;
}

void ShapeSession::removeSelected() {
    if (m_selection.isEmpty() || m_drag) return;
    const auto handles = m_selection.handles();
    const QString name = tr("Remove %1").arg(nameOf(handles));
    m_selection.clear();
    m_document.change(name, withoutHandles(*m_document.project(), handles));
}

void ShapeSession::pushStroke(const std::vector<int>& handles, const std::vector<Vec<2>>& starts,
                              const std::vector<Vec<2>>& offsets, const QString& mergeKey) {
    m_document.change(tr("Move %1").arg(nameOf(handles)),
                      withStroke(*m_document.project(), handles, starts, offsets), mergeKey);
}

void ShapeSession::nudgeSelected(const Vec<2>& by) {
    if (m_selection.isEmpty() || m_drag || !m_frame) return;
    goToEnd();
    const auto handles = m_selection.handles();
    QString key = QStringLiteral("nudge");
    for (const int h : handles) key += QStringLiteral(" %1").arg(h);
    if (m_document.merges(key))
        m_document.change(tr("Move %1").arg(nameOf(handles)),
                          withLongerStroke(*m_document.project(), handles, by), key);
    else
        pushStroke(handles, centresOf(handles), {Vec<2>::Zero(), by}, key);
}

void ShapeSession::beginDrag() {
    if (m_selection.isEmpty() || m_drag || !m_frame) return;
    m_playback.setPlaying(false);
    goToEnd();
    m_drag.emplace(m_selection.handles(), centresOf(m_selection.handles()));
    m_compute.post(BeginDrag{m_selection.handles()});
}

void ShapeSession::dragTo(const Vec<2>& offset) {
    if (!m_drag) return;
    const int sample = m_drag->add(offset);
    m_compute.post(DragTo{{offset}, sample});
    emit pinsChanged();
}

void ShapeSession::endDrag(double tolerance) {
    if (!m_drag) return;
    const DragGesture drag = std::move(*m_drag);
    m_drag.reset();
    const auto path = drag.path(tolerance);
    m_compute.post(EndDrag{path.size() > 1});
    if (path.size() < 2) {
        m_preview.reset();
        showTime();
        return;
    }
    if (m_preview) {  // from now on it stands for the end of the longer motion
        auto preview = std::make_shared<ShapeFrame>(*m_preview);
        preview->time = motionEnd(*m_document.project()) + 1;
        m_preview = preview;
    }
    pushStroke(drag.handles(), drag.starts(), path, {});
}

void ShapeSession::cancelDrag() {
    if (!m_drag) return;
    m_drag.reset();
    m_preview.reset();
    m_compute.post(EndDrag{false});
    showTime();
    emit pinsChanged();
}

void ShapeSession::goToEnd() {
    m_playback.setTime(m_playback.end());
}

std::vector<Vec<2>> ShapeSession::centresOf(const std::vector<int>& handles) const {
    std::vector<Vec<2>> centres;
    const auto views = pins();
    for (const int h : handles) {
        const auto it =
            std::find_if(views.begin(), views.end(), [h](const PinView& v) { return v.handle == h; });
        centres.push_back(it == views.end() ? Vec<2>::Zero() : it->centre);
    }
    return centres;
}

QString ShapeSession::nameOf(const std::vector<int>& handles) const {
    if (handles.size() != 1) return tr("%n pins", nullptr, static_cast<int>(handles.size()));
    return QString::fromStdString(m_document.design().handles[handles.front()].name);
}

}  // namespace wend
