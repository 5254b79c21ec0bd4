#include "app/session/shape_session.h"

#include "app/project/design.h"
#include "app/project/edits/free_name.h"
#include "app/project/edits/handle_edits.h"

namespace wend {

ShapeSession::ShapeSession(QObject* parent) : QObject(parent) {
    connect(&m_document, &Document::projectChanged, this, &ShapeSession::takeProject);
    connect(&m_document, &Document::opened, this, &ShapeSession::reset);
    connect(&m_selection, &Selection::changed, &m_motion, &ShapeMotion::takeSelection);
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
    m_gesture.tellPins();
}

void ShapeSession::takeProject() {
    if (m_document.isEmpty()) return;
    m_gesture.cancel();  // undo during the drag: its handles may no longer exist
    m_selection.prune();
    m_motion.compute();
    m_gesture.tellPins();
}

int ShapeSession::addPin(const Vec3& p) {
    return m_motion.frame() ? addPin(m_motion.frame()->find(p)) : -1;
}

int ShapeSession::addPin(const std::optional<Place>& place) {
    const FramePtr shape = m_motion.frame();
    if (!place) m_document.notify(tr("No pin was set: this place lies outside the shape."));
    if (!place || !shape) return -1;
    return addHandle(std::vector<Vec3>{shape->restAt(*place)}, tr("Pin").toStdString(),
                     shape->partOf(place->cell));
}

int ShapeSession::addHandle(Placement<3> at, const std::string& kind, const std::string& part) {
    if (!m_motion.frame()) return -1;
    m_playback.setPlaying(false);
    const double time = m_motion.gestureTime();
    m_playback.setTime(time);  // that of the picture that is shown
    const std::string name = freeName(namesOf(m_document.design().handles), kind);
    m_motion.setChangeMovesNothing(true);
    m_document.changeDesign(tr("Add %1").arg(QString::fromStdString(name)),
                            withHandle(m_document.design(), std::move(at), name, time, part));
    m_motion.setChangeMovesNothing(false);
    const int handle = m_pins.count() - 1;
    m_selection.set({handle});
    m_document.notify({});  // clears the error about the previous place
    return handle;
}

void ShapeSession::changeHandle(int handle, Placement<3> at) {
    if (!m_gesture.mayChange(handle)) return;
    m_document.changeDesign(tr("Change %1").arg(m_pins.nameOf({handle})),
                            withHandlePlace(m_document.design(), handle, std::move(at)));
}

void ShapeSession::removeSelected() {
    if (m_selection.isEmpty() || m_motion.isDragging()) return;
    const auto handles = m_gesture.unlocked(m_selection.handles());
    if (handles.empty()) return;
    const QString name = tr("Remove %1").arg(m_pins.nameOf(handles));
    m_playback.setPlaying(false);
    const double time = m_motion.gestureTime();
    m_selection.clear();
    m_document.changeDesign(name, withoutHandles(m_document.design(), handles, time));
}

}  // namespace wend
