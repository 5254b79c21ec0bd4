#include "app/views/volume/solid_canvas.h"

namespace wend {

CutPlane SolidCanvas::middlePlane(const Vec<3>& normal) const {
    CutPlane plane;
    plane.normal = normal;
    const auto frame = m_session.frame<3>();
    if (frame) plane.point = (frame->pose.rowwise().minCoeff() + frame->pose.rowwise().maxCoeff()) / 2;
    return plane;
}

/// Cuts away the near half: along the world axis closest to the viewing direction, or along the normal chosen
/// in this document.
Vec<3> SolidCanvas::normalToViewer() const {
    const Vec<3> way = viewDirection();
    Vec<3> normal = m_cutTool.plane().normal;
    if (!m_planeChosen) {
        int axis = 0;
        way.cwiseAbs().maxCoeff(&axis);
        normal = Vec<3>::Unit(axis);
    }
    return normal.dot(way) > 0 ? Vec<3>(-normal) : normal;
}

void SolidCanvas::setCutKind(CutKind kind) {
    if (kind == cut() || (kind != CutKind::None && !m_session.frame<3>())) {
        emit cutChanged();
        return;
    }
    if (cut() == CutKind::None) m_cutTool.setPlane(middlePlane(normalToViewer()));
    m_cutTool.setActive(kind != CutKind::None);
    setCut(kind, m_cutTool.plane());
    refresh();
    emit cutChanged();
}

void SolidCanvas::setCutPlane(const CutPlane& plane) {
    m_planeChosen = true;
    m_cutTool.setPlane(plane);
    setCut(cut(), plane);
    refresh();
    emit cutChanged();
}

}  // namespace wend
