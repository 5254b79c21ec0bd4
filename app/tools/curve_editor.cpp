#include "app/tools/curve_editor.h"

#include <Eigen/Geometry>
#include <QCoreApplication>

namespace wend {

namespace {

constexpr double kReach = 8;  // pixels
const QColor kLine(0xd4, 0x7a, 0x1e);

/// Where the screen's plane through a point is under the pointer.
Vec<3> acrossTheScreen(const SolidSurface& surface, const Vec<3>& p, const QPointF& widget) {
    const Ray ray = surface.ray(widget);
    const Vec<3> normal = surface.viewDirection();
    return ray.origin + normal.dot(p - ray.origin) / normal.dot(ray.direction) * ray.direction;
}

}  // namespace

int CurveEditor::handle() const {
    const auto& selected = m_surface.session().selection().handles();
    return m_surface.session().document().dimension() == 3 && selected.size() == 1 ? selected.front() : -1;
}

/// From the curve's own place to where the handle really begins to follow it.
Vec<3> CurveEditor::shift() const {
    ShapeSession& session = m_surface.session();
    Handle<3> before = session.document().design<3>().handles[handle()];
    const auto curve = std::get<CurveMotion<3>>(before.motions.back().kind);
    before.motions.pop_back();
    const auto starts = session.pathStarts<3>(handle());
    if (starts.empty()) return Vec<3>::Zero();
    return pinPaths<3>(before, {meanOf<3>(starts)}).front().points.back() - curve.points.front();
}

std::vector<Vec<3>> CurveEditor::points() const {
    if (handle() < 0) return {};
    Project project = *m_surface.session().document().project();
    const CurveMotion<3>* curve = lastCurve(project, handle());
    if (!curve || !m_surface.session().frame<3>()) return {};
    std::vector<Vec<3>> points = curve->points;
    const Vec<3> by = shift();
    for (Vec<3>& p : points) p += by;
    if (m_dragged > 0 && m_dragged < static_cast<int>(points.size())) points[m_dragged] += m_by;
    return points;
}

int CurveEditor::pointAt(const QPointF& widget) const {
    const auto all = points();
    int best = -1;
    double nearest = kReach;
    for (int i = 1; i < static_cast<int>(all.size()); ++i) {
        const double d = QLineF(m_surface.toWidget(all[i]), widget).length();
        if (d < nearest) nearest = d, best = i;
    }
    return best;
}

void CurveEditor::begin(int point, const QPointF& widget) {
    m_dragged = point;
    m_from = widget;
    m_by.setZero();
}

void CurveEditor::drag(const QPointF& widget) {
    const Vec<3> p = points()[m_dragged] - m_by;
    m_by = acrossTheScreen(m_surface, p, widget) - acrossTheScreen(m_surface, p, m_from);
    m_surface.redraw();
}

void CurveEditor::finish() {
    const int point = std::exchange(m_dragged, -1);
    Project next = *m_surface.session().document().project();
    CurveMotion<3>* curve = handle() >= 0 ? lastCurve(next, handle()) : nullptr;
    if (!curve || m_by.isZero()) return;
    curve->points[point] += m_by;
    m_surface.session().document().change(QCoreApplication::translate("CurveEditor", "Change curve"),
                                          std::move(next));
}

void CurveEditor::paint(QPainter& painter, const QPointF& pointer) const {
    const auto all = points();
    if (all.empty()) return;
    QPolygonF screen;
    for (const Vec<3>& p : all) screen << m_surface.toWidget(p);
    Project project = *m_surface.session().document().project();
    const bool bezier = lastCurve(project, handle())->interpolation == Interpolation::Bezier;
    painter.setPen(QPen(kLine, 1.25));
    for (int i = 0; bezier && i + 3 < screen.size(); i += 3) {  // from the joints to their directions
        painter.drawLine(screen[i], screen[i + 1]);
        painter.drawLine(screen[i + 2], screen[i + 3]);
    }
    for (int i = 1; i < screen.size(); ++i) {
        const double r = QLineF(screen[i], pointer).length() < kReach ? 5.5 : 4.5;
        painter.setPen(QPen(Qt::white, 1.25));
        painter.setBrush(kLine);
        if (bezier && i % 3 == 0)
            painter.drawRect(QRectF(screen[i].x() - r, screen[i].y() - r, 2 * r, 2 * r));
        else
            painter.drawEllipse(screen[i], r, r);
    }
}

}  // namespace wend
