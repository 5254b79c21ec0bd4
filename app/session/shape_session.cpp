#include "app/session/shape_session.h"

#include "app/engine/shape/mesh_parts.h"
#include "app/project/design.h"
#include "app/project/edits/free_name.h"
#include "app/project/edits/handle_edits.h"

namespace wend {

ShapeSession::ShapeSession(QObject* parent) : QObject(parent) {
    connect(&m_document, &Document::projectChanged, this, &ShapeSession::takeProject);
    connect(&m_document, &Document::opened, this, &ShapeSession::reset);
    connect(&m_selection, &Selection::changed, this, &ShapeSession::pinsChanged);
    connect(&m_selection, &Selection::changed, &m_motion, &ShapeMotion::takeSelection);
    connect(&m_motion, &ShapeMotion::frameChanged, this, &ShapeSession::frameChanged);
    connect(&m_motion, &ShapeMotion::busyChanged, this, &ShapeSession::busyChanged);
    connect(&m_motion, &ShapeMotion::progress, this, &ShapeSession::progress);
    connect(&m_motion, &ShapeMotion::within, this, &ShapeSession::within);
    connect(&m_motion, &ShapeMotion::notice, this, &ShapeSession::notice);
    connect(&m_motion, &ShapeMotion::problem, this, &ShapeSession::problem);
    connect(&m_gesture, &ShapeGesture::began, this, &ShapeSession::dragBegan);
    connect(&m_gesture, &ShapeGesture::moved, this, &ShapeSession::dragMoved);
    connect(&m_gesture, &ShapeGesture::ended, this, &ShapeSession::dragEnded);
    connect(&m_gesture, &ShapeGesture::cancelled, this, &ShapeSession::dragCancelled);
    connect(&m_gesture, &ShapeGesture::pinsChanged, this, &ShapeSession::pinsChanged);
    connect(&m_gesture, &ShapeGesture::notice, this, &ShapeSession::notice);
}

/// Resets all state of the last file before any signal is emitted, so that no observer sees the old shape,
/// selection or drag with the new project.
void ShapeSession::reset() {
    m_gesture.drop();
    m_motion.drop();
    m_pins.drop();
    m_selection.clear();
    m_playback.setPlaying(false);
    m_playback.setEnd(0);
    m_motion.tellDropped();
    emit pinsChanged();
}

void ShapeSession::takeProject() {
    if (m_document.isEmpty()) return;
    cancelDrag();  // undo during the drag: its handles may no longer exist
    std::vector<int> kept = m_selection.handles();
    std::erase_if(kept, [count = handleCount()](int h) { return h >= count; });
    m_selection.set(std::move(kept));
    m_motion.compute();
    emit pinsChanged();
}

void ShapeSession::cancelWork() {
    if (!isBusy()) return;
    cancelDrag();
    m_motion.cancelWork();
}

int ShapeSession::singleHandle() const {
    const auto& selected = m_selection.handles();
    if (m_document.isEmpty() || selected.size() != 1) return -1;
    return selected.front() < handleCount() ? selected.front() : -1;
}

template <int Dim>
int ShapeSession::addPin(const Vec<Dim>& p) {
    const auto shape = frame<Dim>();
    return shape ? addPin<Dim>(PointLocator<Dim>(shape->pose, shape->rest->cells).find(p)) : -1;
}

template <int Dim>
int ShapeSession::addPin(const std::optional<Location<Dim>>& place) {
    const auto shape = frame<Dim>();
    if (!place) emit notice(tr("No pin was set: this place lies outside the shape."));
    if (!place || !shape) return -1;
    return addHandle<Dim>(std::vector<Vec<Dim>>{positionOf<Dim>(*place, *shape->rest, shape->rest->points)},
                          tr("Pin").toStdString(), partNameOf<Dim>(*shape->rest, place->cell));
}

template <int Dim>
int ShapeSession::addHandle(Placement<Dim> at, const std::string& kind, const std::string& part) {
    if (!frame<Dim>()) return -1;
    m_playback.setPlaying(false);
    const double time = m_motion.gestureTime();
    m_playback.setTime(time);  // that of the picture that is shown
    const std::string name = freeName(namesOf(m_document.design().handles), kind);
    m_motion.setChangeMovesNothing(true);
    m_document.changeDesign(tr("Add %1").arg(QString::fromStdString(name)),
                            withHandle(m_document.design(), inSpace(at), name, time, part));
    m_motion.setChangeMovesNothing(false);
    const int handle = handleCount() - 1;
    m_selection.set({handle});
    emit notice({});  // clears the error about the previous place
    return handle;
}

template <int Dim>
void ShapeSession::changeHandle(int handle, Placement<Dim> at) {
    if (!mayChange(handle)) return;
    m_document.changeDesign(tr("Change %1").arg(nameOf({handle})),
                            withHandlePlace(m_document.design(), handle, inSpace(at)));
}

void ShapeSession::removeSelected() {
    if (m_selection.isEmpty() || isDragging()) return;
    const auto handles = m_gesture.unlocked(m_selection.handles());
    if (handles.empty()) return;
    const QString name = tr("Remove %1").arg(nameOf(handles));
    m_playback.setPlaying(false);
    const double time = m_motion.gestureTime();
    m_selection.clear();
    m_document.changeDesign(name, withoutHandles(m_document.design(), handles, time));
}

#define WEND_INSTANTIATE(Dim)                                                                          \
    template int ShapeSession::addPin<Dim>(const Vec<Dim>&);                                           \
    template int ShapeSession::addPin<Dim>(const std::optional<Location<Dim>>&);                       \
    template int ShapeSession::addHandle<Dim>(Placement<Dim>, const std::string&, const std::string&); \
    template void ShapeSession::changeHandle<Dim>(int, Placement<Dim>)

WEND_INSTANTIATE(2);
WEND_INSTANTIATE(3);
#undef WEND_INSTANTIATE

}  // namespace wend
