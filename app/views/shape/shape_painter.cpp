#include "app/views/shape/shape_painter.h"

#include "app/engine/motion/pose_places.h"
#include "app/project/design.h"
#include "app/session/pins/pin_shapes.h"
#include "app/style/mark_size.h"
#include "app/style/pin_marks.h"
#include "app/tools/drag_label.h"
#include "app/tools/pins/pin_picking.h"
#include "app/tools/region_outline.h"
#include "app/views/shape/looks.h"
#include "core/motion/trajectory.h"

namespace wend {

namespace {

constexpr int kFramesAlongCurve = 9;
constexpr double kBeside = 24, kHalfLabel = 12, kFramesApart = 16;  // pixels

/// An axis of the frames that a curve carries along, and how long it is, in pixels.
struct Axis {
    QColor colour;
    double size;
};

Axis axisOf(int dimension, int k) {
    if (dimension == 2)
        return k == 0 ? Axis{QColor(0xd4, 0x3d, 0x51), 22} : Axis{QColor(0x12, 0xa5, 0x94), 14};
    return {kSpaceAxes[k], 26};
}

/// Returns whether the mark represents more than a point.
bool isArea(const PinView<2>& view) {
    return view.region;
}
bool isArea(const PinView<3>& view) {
    return view.points.size() > 1;
}

}  // namespace

template <int Dim>
QPolygonF ShapePainter<Dim>::toWidget(const std::vector<Vec<Dim>>& points) const {
    QPolygonF line;
    for (const Vec<Dim>& p : points) line << m_surface.toWidget(p);
    return line;
}

/// Draws the moving frames of a curve from its actual start, without overlaps.
template <int Dim>
void ShapePainter<Dim>::frames(const Pin& handle, const Vec<Dim>& start) {
    Vec<Dim> from = start;
    for (const PinMotion& motion : handle.motions) {
        const auto* curve = std::get_if<CurveMotion<3>>(&motion.kind);
        const Trajectory<Dim> trajectory(motionIn<Dim>(motion));
        std::optional<QPointF> last;
        for (int i = 0; curve && curve->frame != FrameKind::None && i < kFramesAlongCurve; ++i) {
            const double t = motion.start + (motion.end - motion.start) * i / (kFramesAlongCurve - 1);
            const Vec<Dim> at = trajectory.at(t).position(from);
            const QPointF seen = m_surface.toWidget(at);
            if (last && QLineF(*last, seen).length() < marked(kFramesApart)) continue;
            last = seen;
            frame(at, trajectory.frame(t));
        }
        from = trajectory.at(motion.end).position(from);
    }
}

template <int Dim>
void ShapePainter<Dim>::frame(const Vec<Dim>& at, const Mat<Dim>& axes) {
    const double pixel = marked(m_surface.pixelSize(at));
    for (int k = 0; k < Dim; ++k) {
        const auto [colour, size] = axisOf(Dim, k);
        m_marks.line(toWidget({at, at + size * pixel * axes.col(k)}), colour, 1.75, Qt::SolidLine);
    }
}

template <int Dim>
void ShapePainter<Dim>::paths(int hovered) {
    if (session().document().dimension() != Dim) return;
    m_marks.setQuick(session().isDragging());
    const double time = session().playback().time();
    const auto& handles = session().document().design().handles;
    for (const bool selected : {false, true})
        for (int h = 0; h < static_cast<int>(handles.size()); ++h) {
            if (handles[h].motions.empty() || session().selection().contains(h) != selected) continue;
            if (handles[h].activeTo <= time || handles[h].traits.hidden) continue;  // released
            const auto starts = shownStarts<Dim>(session().template pathStarts<Dim>(h));
            if (starts.empty()) continue;
            for (const PinPath<Dim>& one : pinPaths<Dim>(handles[h], starts))
                m_marks.path(toWidget(one.points), one.times, selected, time, h == hovered);
            if (selected) frames(handles[h], starts.front());
        }
}

template <>
void ShapePainter<2>::spots(const PinView<2>& view) {
    const bool selected = session().selection().contains(view.handle);
    const QPolygonF places = toWidget(view.points);
    m_marks.spots({places.begin(), places.end()}, selected ? m_theme.accent : kInk, 3.2, QPen(Qt::white, 1));
}

/// Draws the vertices that a handle holds where they are visible; of a selected one also hidden ones,
/// faintly.
template <>
void ShapePainter<3>::spots(const PinView<3>& view) {
    const bool selected = session().selection().contains(view.handle);
    const double r = selected ? 2.3 : 1.7;
    std::vector<QPointF> seen, hidden;
    for (const VertexMark& mark : m_surface.marksOf(session().verticesOf(view.handle)))
        (mark.hidden ? hidden : seen).push_back(m_surface.toWidget(mark.at));
    QColor fill = selected ? m_theme.accent : kInk;
    fill.setAlpha(70);
    if (selected) m_marks.spots(hidden, fill, r, Qt::NoPen);
    fill.setAlpha(selected ? 255 : 110);
    m_marks.spots(seen, fill, r, selected ? QPen(QColor(255, 255, 255, 190), 0.75) : QPen(Qt::NoPen));
}

/// A part of the shape that is held as a whole: its outline veils nothing until it is pointed at.
template <>
void ShapePainter<2>::region(const PinView<2>& view, bool hovered) {
    const auto frame = session().frame<2>();
    if (!frame) return;
    const bool selected = session().selection().contains(view.handle);
    QPolygonF border =
        toWidget(regionBorder(session().document().design().handles[view.handle], view, *frame));
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

/// The outline of a selected handle's region, carried to where its vertices are now.
template <>
void ShapePainter<3>::region(const PinView<3>& view, bool) {
    const auto frame = session().frame<3>();
    const auto* region = std::get_if<Region<3>>(&session().document().design().handles[view.handle].at);
    if (!region || !frame || !session().selection().contains(view.handle)) return;
    const auto& rest = frame->rest->points;
    std::vector<Vec<3>> held;
    for (const int v : verticesInside<3>(*region, *frame->rest)) held.push_back(rest.col(v));
    const auto carry = carryingBetween<3>(held, view.points);
    for (auto line : regionOutline(*region, rest.rowwise().minCoeff(), rest.rowwise().maxCoeff())) {
        for (Vec<3>& p : line) p = carry(p);
        m_marks.line(toWidget(line), m_theme.accent, 1.25, Qt::CustomDashLine);
    }
}

template <int Dim>
void ShapePainter<Dim>::pins(int hovered, int named) {
    if (session().document().dimension() != Dim) return;
    const auto pins = session().template pins<Dim>();
    m_marks.setQuick(session().isDragging());
    for (const PinView<Dim>& view : pins)
        if (view.region) region(view, view.handle == hovered);
    for (const PinView<Dim>& view : pins)
        if (view.points.size() > 1 && (Dim == 3 || !view.region)) spots(view);
    PinScene<Dim>{session(),
                  pins,
                  hovered,
                  named,
                  [this](const Vec<Dim>& p) { return m_surface.toWidget(p); },
                  [](const PinView<Dim>& view) { return isArea(view); },
                  [this](const PinView<Dim>& view) { return isMarkCovered<Dim>(m_surface, view); }}
        .paint(m_painter, m_marks);
}

template <int Dim>
void ShapePainter<Dim>::groups(const std::vector<GroupMark>& groups) {
    const auto frame = session().template frame<Dim>();
    if (!frame) return;
    for (const GroupMark& group : groups) {
        std::vector<QPointF> places;
        if constexpr (Dim == 3) {
            for (const VertexMark& mark : m_surface.marksOf(group.vertices))
                if (!mark.hidden) places.push_back(m_surface.toWidget(mark.at));
        } else {
            for (const int v : group.vertices)
                if (v < frame->pose.cols()) places.push_back(m_surface.toWidget(frame->pose.col(v)));
        }
        QColor fill = group.colour;
        fill.setAlpha(group.chosen ? 255 : 150);
        m_marks.spots(places, fill, group.chosen ? 3.4 : 1.8,
                      group.chosen ? QPen(Qt::white, 1) : QPen(Qt::NoPen));
    }
}

/// Draws the points, or an even selection if there are very many.
template <int Dim>
void ShapePainter<Dim>::dots(const Points<Dim>& points) {
    constexpr Eigen::Index kMost = 20000;
    const Eigen::Index step = std::max<Eigen::Index>(1, points.cols() / kMost);
    std::vector<QPointF> places;
    for (Eigen::Index k = 0; k < points.cols(); k += step)
        places.push_back(m_surface.toWidget(points.col(k)));
    m_marks.spots(places, kInk, 1.4, QPen(QColor(255, 255, 255, 190), 0.6));
}

template <int Dim>
void ShapePainter<Dim>::worst(const PosedFrame<Dim>& frame, int cell, const QString& words) {
    if (cell < 0) return;
    std::optional<Vec<Dim>> place = centreOf<Dim>(frame, cell);
    if constexpr (Dim == 3) place = m_surface.placeOf(cell);
    const QPointF at = m_surface.toWidget(place ? *place : centreOf<Dim>(frame, cell));
    m_marks.worst(at, !place);
    if (words.isEmpty()) return;
    const bool isLeft = at.x() > m_painter.viewport().width() / 2.0;  // the side with more room
    paintLabel(m_painter, at + QPointF(isLeft ? -kBeside : kBeside, -kHalfLabel), words, isLeft);
}

template class ShapePainter<2>;
template class ShapePainter<3>;

void paintFaults(QPainter& painter, ToolSurface& surface, const PosedFrame<2>& frame,
                 const PoseFaults<2>& faults) {
    Marks marks(painter);
    QColor fill(kWrong);
    fill.setAlphaF(0.75F);
    painter.setPen(Qt::NoPen);
    painter.setBrush(fill);
    const auto at = [&](const Points<2>& points, int v) { return surface.toWidget(Vec<2>(points.col(v))); };
    for (const auto& place : faults.blown)
        for (const int cell : place.members) {
            QPolygonF corners;
            for (const int v : frame.rest->cells[cell]) corners << at(frame.pose, v);
            painter.drawPolygon(corners);
        }
    for (const auto& place : faults.crossings)
        for (const int edge : place.members) {
            const auto& [a, b] = faults.border[edge];
            marks.line({at(faults.points, a), at(faults.points, b)}, QColor(kWrong), 2.5, Qt::SolidLine);
        }
}

}  // namespace wend
