#include "app/tools/mesh/cut_tool.h"
#include "app/session/shape_session.h"

#include <Eigen/Geometry>
#include <QCoreApplication>
#include <utility>

namespace wend {

void CutTool::setPlane(const CutPlane& plane) {
    m_plane = plane;
    if (!m_dragging) place();
}

void CutTool::choosePlane(const CutPlane& plane) {
    m_chosenIn = session().document().generation();
    setPlane(plane);
}

void CutTool::placeInMiddle() {
    const auto frame = session().motion().frame<3>();
    if (!frame) return;
    const Vec3 way = view().viewDirection();
    CutPlane plane = m_plane;
    plane.point = (frame->pose.rowwise().minCoeff() + frame->pose.rowwise().maxCoeff()) / 2;
    if (m_chosenIn != session().document().generation()) {
        int axis = 0;
        way.cwiseAbs().maxCoeff(&axis);
        plane.normal = Vec3::Unit(axis);
    }
    if (plane.normal.dot(way) > 0) plane.normal = -plane.normal;
    setPlane(plane);
}

void CutTool::place() {
    Mat3 axes;
    axes.col(2) = m_plane.normal.normalized();
    axes.col(0) = axes.col(2).unitOrthogonal();
    axes.col(1) = axes.col(2).cross(axes.col(0));
    m_manipulator.setMode(Manipulator::Mode::Tilt);
    m_manipulator.place(m_plane.point, axes);
}

QString CutTool::hint() const {
    return QCoreApplication::translate(
        "CutTool", "Drag the arrow to move the cut, the rings to tilt it; Esc puts it back");
}

QCursor CutTool::cursor() const {
    return m_dragging ? Qt::ClosedHandCursor : Qt::OpenHandCursor;
}

bool CutTool::wants(const QPointF& at) const {
    return isShown() && (m_dragging || m_manipulator.partAt(view(), at));
}

void CutTool::press(const QMouseEvent& event) {
    const auto part = m_manipulator.partAt(view(), event.position());
    if (!part) return;
    m_part = part;
    m_start = m_plane;
    m_dragging = true;
    m_manipulator.begin(*part, view(), event.position());
}

void CutTool::move(const QMouseEvent& event) {
    if (!m_dragging) {
        m_part = isShown() ? m_manipulator.partAt(view(), event.position()) : std::nullopt;
        view().redraw();
        return;
    }
    const Amount amount = m_manipulator.drag(view(), event.position());
    const Grip grip = m_manipulator.grip(view());
    m_plane.point = carried(grip, amount, m_start.point);
    m_plane.normal = carried(grip, amount, Vec3(m_start.point + m_start.normal)) - m_plane.point;
    m_changed(m_plane);
}

void CutTool::release(const QMouseEvent&) {
    m_dragging = false;
    place();
}

bool CutTool::key(const QKeyEvent& event) {
    if (!m_dragging || event.key() != Qt::Key_Escape) return false;
    cancel();
    return true;
}

void CutTool::cancel() {
    if (!std::exchange(m_dragging, false)) return;
    m_plane = m_start;
    m_changed(m_plane);
    place();
}

void CutTool::paint(QPainter& painter) const {
    if (!isShown()) return;
    Manipulator shown = m_manipulator;
    if (m_dragging) {
        CutTool copy(view(), {}, {});
        copy.setPlane(m_plane);
        shown = copy.m_manipulator;
    }
    shown.paint(painter, view(), m_part);
}

}  // namespace wend
