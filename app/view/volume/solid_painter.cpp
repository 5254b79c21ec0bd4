#include "app/view/volume/solid_painter.h"

#include <algorithm>
#include <cmath>

#include "app/document/design.h"
#include "app/panels/pin_marks.h"
#include "app/session/mark_size.h"
#include "app/session/pin_shapes.h"
#include "app/session/solid_places.h"
#include "app/tools/pin_picking.h"
#include "app/tools/region_outline.h"
#include "core/motion/trajectory.h"

namespace wend {

namespace {

constexpr int kFramesAlongCurve = 9;
const QColor kAxes[] = {QColor(214, 69, 65), QColor(72, 148, 60), QColor(58, 104, 214)};

/// The points of a selected curve, which may lie far outside of it.
void addDirections(const Handle<3>& handle, const PinPath<3>& path, std::vector<Vec<3>>& points) {
    for (const Motion<3>& motion : handle.motions) {
        const auto* curve = std::get_if<CurveMotion<3>>(&motion.kind);
        const auto at = std::lower_bound(path.times.begin(), path.times.end(), motion.start);
        if (!curve || curve->points.empty() || at == path.times.end()) continue;
        const Vec<3> start = path.points[static_cast<std::size_t>(at - path.times.begin())];
        for (const Vec<3>& p : curve->points) points.push_back(start + p - curve->points.front());
    }
}

Vec<3> centreOf(const PosedFrame<3>& frame, int cell) {
    Vec<3> centre = Vec<3>::Zero();
    for (const int v : frame.rest->cells[cell]) centre += frame.pose.col(v) / 4;
    return centre;
}

}  // namespace

QPolygonF SolidPainter::toWidget(const std::vector<Vec<3>>& points) const {
    QPolygonF line;
    for (const Vec<3>& p : points) line << m_surface.toWidget(p);
    return line;
}

/// The local frames that a curve carries along.
void SolidPainter::frames(const Handle<3>& handle, const Vec<3>& start) {
    for (const Motion<3>& motion : handle.motions) {
        const auto* curve = std::get_if<CurveMotion<3>>(&motion.kind);
        if (!curve || curve->frame == FrameKind::None) continue;
        const Trajectory<3> trajectory(motion);
        for (int i = 0; i < kFramesAlongCurve; ++i) {
            const double t = motion.start + (motion.end - motion.start) * i / (kFramesAlongCurve - 1);
            const Vec<3> at = trajectory.at(t).position(start);
            const Mat<3> F = trajectory.frame(t);
            for (int k = 0; k < 3; ++k)
                m_marks.line({m_surface.toWidget(at),
                              m_surface.toWidget(at + marked(26) * m_surface.pixelSize(at) * F.col(k))},
                             kAxes[k], 1.75, Qt::SolidLine);
        }
    }
}

void SolidPainter::paths() {
    ShapeSession& session = m_surface.session();
    if (session.document().dimension() != 3) return;
    m_marks.setQuick(session.isDragging());
    const auto& handles = session.document().design<3>().handles;
    for (const bool selected : {false, true})
        for (int h = 0; h < static_cast<int>(handles.size()); ++h) {
            if (handles[h].motions.empty() || session.selection().contains(h) != selected) continue;
            if (handles[h].activeTo <= session.playback().time()) continue;  // let go of
            if (handles[h].traits.hidden) continue;
            const auto starts = shownStarts<3>(session.pathStarts<3>(h));
            if (starts.empty()) continue;
            for (const PinPath<3>& one : pinPaths<3>(handles[h], starts))
                m_marks.path(toWidget(one.points), one.times, selected, session.playback().time());
            if (selected) frames(handles[h], starts.front());
        }
}

std::vector<Vec<3>> pathPoints(ShapeSession& session) {
    std::vector<Vec<3>> points;
    for (const PinView<3>& view : session.pins<3>()) points.push_back(view.centre);
    const auto& handles = session.document().design<3>().handles;
    for (int h = 0; h < static_cast<int>(handles.size()); ++h) {
        const auto starts = session.pathStarts<3>(h);
        if (handles[h].motions.empty() || starts.empty() || handles[h].traits.hidden) continue;
        for (const PinPath<3>& path : pinPaths<3>(handles[h], shownStarts<3>(starts))) {
            points.insert(points.end(), path.points.begin(), path.points.end());
            if (session.selection().contains(h)) addDirections(handles[h], path, points);
        }
    }
    return points;
}

/// What a handle of many vertices holds, where it is seen; of a selected one also what is hidden, faintly.
void SolidPainter::spots(const PinView<3>& view, const QColor& colour) {
    const bool selected = m_surface.session().selection().contains(view.handle);
    const double r = selected ? 2.3 : 1.7;
    std::vector<QPointF> seen, hidden;
    for (const VertexMark& mark : m_surface.marksOf(m_surface.session().verticesOf(view.handle)))
        (mark.hidden ? hidden : seen).push_back(m_surface.toWidget(mark.at));
    QColor fill = colour;
    fill.setAlpha(70);
    if (selected) m_marks.spots(hidden, fill, r, Qt::NoPen);
    fill.setAlpha(selected ? 255 : 110);
    m_marks.spots(seen, fill, r, selected ? QPen(QColor(255, 255, 255, 190), 0.75) : QPen(Qt::NoPen));
}

/// The outline of a selected handle's region, carried to where its vertices are now.
void SolidPainter::region(const PinView<3>& view) {
    ShapeSession& session = m_surface.session();
    const auto frame = session.frame<3>();
    const auto& at = session.document().design<3>().handles[view.handle].at;
    const auto* region = std::get_if<Region<3>>(&at);
    if (!region || !frame) return;
    const auto& rest = frame->rest->points;
    std::vector<Vec<3>> held;
    for (const int v : verticesIn(*region, *frame->rest)) held.push_back(rest.col(v));
    const Carrying carry = carryingOf(held, view.points);
    for (auto line : regionOutline(*region, rest.rowwise().minCoeff(), rest.rowwise().maxCoeff())) {
        for (Vec<3>& p : line) p = carry(p);
        m_marks.line(toWidget(line), m_theme.accent, 1.25, Qt::CustomDashLine);
    }
}

void SolidPainter::pins(const PinAnimation& animation, int hovered) {
    ShapeSession& session = m_surface.session();
    if (session.document().dimension() != 3) return;
    const auto pins = session.pins<3>();
    m_marks.setQuick(session.isDragging());
    for (const PinView<3>& view : pins)
        if (view.region && session.selection().contains(view.handle)) region(view);
    for (const PinView<3>& view : pins)
        if (view.points.size() > 1)
            spots(view, session.selection().contains(view.handle) ? m_theme.accent : kInk);
    PinScene<3>{session,
                animation,
                pins,
                hovered,
                [this](const Vec<3>& p) { return m_surface.toWidget(p); },
                [](const PinView<3>& view) { return view.points.size() > 1; },
                [this](const PinView<3>& view) { return isCovered<3>(m_surface, view); }}
        .paint(m_painter, m_marks);
}

void SolidPainter::worst(const PosedFrame<3>& frame, int cell) {
    if (cell < 0) return;
    const auto seen = m_surface.placeOf(cell);
    m_marks.worst(m_surface.toWidget(seen ? *seen : centreOf(frame, cell)), !seen);
}

void SolidPainter::compass(const QPointF& at, const Mat<3>& worldToScreen) {
    std::array<int, 3> order = {0, 1, 2};  // the nearest last
    std::sort(order.begin(), order.end(),
              [&](int a, int b) { return worldToScreen(2, a) < worldToScreen(2, b); });
    static const QString kNames[] = {QStringLiteral("X"), QStringLiteral("Y"), QStringLiteral("Z")};
    QFont font = m_painter.font();
    font.setPointSizeF(font.pointSizeF() * 0.85);
    font.setBold(true);
    m_painter.setFont(font);
    for (const int k : order) {
        const QPointF tip = at + 30 * QPointF(worldToScreen(0, k), -worldToScreen(1, k));
        m_painter.setPen(QPen(kAxes[k], 2.25, Qt::SolidLine, Qt::RoundCap));
        m_painter.drawLine(at, tip);
        m_painter.setPen(Qt::NoPen);
        m_painter.setBrush(kAxes[k]);
        m_painter.drawEllipse(tip, 8, 8);
        m_painter.setPen(Qt::white);
        m_painter.drawText(QRectF(tip.x() - 8, tip.y() - 8, 16, 16), Qt::AlignCenter, kNames[k]);
    }
}

}  // namespace wend
