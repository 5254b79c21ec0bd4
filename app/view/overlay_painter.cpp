#include "app/view/overlay_painter.h"

#include <QCoreApplication>
#include <cmath>

#include "app/document/design.h"
#include "app/panels/pin_marks.h"
#include "app/session/mark_size.h"
#include "app/session/pin_shapes.h"
#include "app/tools/region_outline.h"
#include "core/motion/trajectory.h"

namespace wend {

namespace {

constexpr int kFramesAlongCurve = 9;
constexpr double kFrameSize = 22;  // pixels
constexpr double kFrameSizeY = 14;
const QColor kFrameAxes[] = {QColor(0xd4, 0x3d, 0x51), QColor(0x12, 0xa5, 0x94)};

}  // namespace

QPolygonF OverlayPainter::toWidget(const std::vector<Vec<2>>& points) const {
    QPolygonF line;
    for (const Vec<2>& p : points) line << m_view.toWidget(p);
    return line;
}

/// The local frames that a curve carries along.
void OverlayPainter::frames(const Handle<2>& handle, const Vec<2>& start) {
    for (const Motion<2>& motion : handle.motions) {
        const auto* curve = std::get_if<CurveMotion<2>>(&motion.kind);
        if (!curve || curve->frame == FrameKind::None) continue;
        const Trajectory<2> trajectory(motion);
        for (int i = 0; i < kFramesAlongCurve; ++i) {
            const double t = motion.start + (motion.end - motion.start) * i / (kFramesAlongCurve - 1);
            const Vec<2> at = trajectory.at(t).position(start);
            const Mat<2> F = trajectory.frame(t);
            for (int k = 0; k < 2; ++k)
                m_marks.line(
                    {m_view.toWidget(at), m_view.toWidget(at + marked(k == 0 ? kFrameSize : kFrameSizeY) /
                                                                   m_view.zoom() * F.col(k))},
                    kFrameAxes[k], 1.75, Qt::SolidLine);
        }
    }
}

void OverlayPainter::paths(ShapeSession& session, int hovered) {
    if (session.document().isEmpty()) return;
    m_marks.setQuick(session.isDragging());
    const auto& handles = session.document().design<2>().handles;
    for (const bool selected : {false, true})
        for (int h = 0; h < static_cast<int>(handles.size()); ++h) {
            if (handles[h].motions.empty() || session.selection().contains(h) != selected) continue;
            if (handles[h].activeTo <= session.playback().time()) continue;  // let go of
            if (handles[h].traits.hidden) continue;
            const auto starts = shownStarts<2>(session.pathStarts(h));
            for (const PinPath<2>& one : pinPaths(handles[h], starts))
                m_marks.path(toWidget(one.points), one.times, selected, session.playback().time(),
                             h == hovered);
            if (selected && !starts.empty()) frames(handles[h], starts.front());
        }
}

void OverlayPainter::spots(const PinView<2>& view, const QColor& colour) {
    std::vector<QPointF> places;
    for (const Vec<2>& p : view.points) places.push_back(m_view.toWidget(p));
    m_marks.spots(places, colour, 3.2, QPen(Qt::white, 1));
}

/// A part of the shape that is held as a whole: its outline veils nothing until it is pointed at.
void OverlayPainter::region(const Handle<2>& handle, const PinView<2>& view, const PosedFrame<2>& frame,
                            bool selected, bool hovered) {
    QPolygonF border = toWidget(regionBorder(handle, view, frame));
    if (border.isEmpty()) return;
    border << border.first();
    if (hovered) {
        QColor fill = m_theme.accent;
        fill.setAlphaF(0.08F);
        m_painter.setPen(Qt::NoPen);
        m_painter.setBrush(fill);
        m_painter.drawPolygon(border);
    }
    m_marks.line(border, selected ? m_theme.accent : kInk, selected ? 2 : 1.25,
                 selected ? Qt::SolidLine : Qt::CustomDashLine);
}

void OverlayPainter::pins(ShapeSession& session, const PinAnimation& animation, int hovered,
                          const std::function<bool(const PinView<2>&)>& isCovered) {
    const auto frame = session.frame<2>();
    const auto pins = session.pins();
    const auto& handles = session.document().design<2>().handles;
    m_marks.setQuick(session.isDragging());
    for (const PinView<2>& view : pins) {
        const bool selected = session.selection().contains(view.handle);
        if (view.region && frame)
            region(handles[view.handle], view, *frame, selected, view.handle == hovered);
        else if (view.points.size() > 1)
            spots(view, selected ? m_theme.accent : kInk);
    }
    PinScene<2>{session,
                animation,
                pins,
                hovered,
                [this](const Vec<2>& p) { return m_view.toWidget(p); },
                [](const PinView<2>& view) { return view.region; },
                isCovered}
        .paint(m_painter, m_marks);
}

void OverlayPainter::worst(const PosedFrame<2>& frame, int cell) {
    if (cell < 0) return;
    Vec<2> centre = Vec<2>::Zero();
    for (const int v : frame.rest->cells[cell]) centre += frame.pose.col(v) / 3;
    m_marks.worst(m_view.toWidget(centre));
}

void OverlayPainter::faults(const PosedFrame<2>& frame, const PoseFaults<2>& faults) {
    QColor fill(kWrong);
    fill.setAlphaF(0.75F);
    m_painter.setPen(Qt::NoPen);
    m_painter.setBrush(fill);
    const auto at = [&](const Points<2>& points, int v) { return m_view.toWidget(Vec<2>(points.col(v))); };
    for (const auto& place : faults.blown)
        for (const int cell : place.members) {
            QPolygonF corners;
            for (const int v : frame.rest->cells[cell]) corners << at(frame.pose, v);
            m_painter.drawPolygon(corners);
        }
    for (const auto& place : faults.crossings)
        for (const int edge : place.members) {
            const auto& [a, b] = faults.border[edge];
            m_marks.line({at(faults.points, a), at(faults.points, b)}, QColor(kWrong), 2.5, Qt::SolidLine);
        }
}

}  // namespace wend
