#include "app/views/shape/shape_painter.h"

#include <QCoreApplication>
#include <QLocale>
#include <algorithm>

#include "app/engine/motion/places.h"
#include "app/project/design.h"
#include "app/session/pins/pin_shapes.h"
#include "app/session/shape_session.h"
#include "app/style/marks.h"
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

}  // namespace

QString ghostName(const Pin& handle, const QString& name, double time) {
    const bool isYetToCome = time < handle.activeFrom;
    const QString when = QLocale().toString(isYetToCome ? handle.activeFrom : handle.activeTo, 'f', 2);
    return (isYetToCome ? QCoreApplication::translate("PinTool", "%1: holds from %2 s")
                        : QCoreApplication::translate("PinTool", "%1: released at %2 s"))
        .arg(name, when);
}

bool ShapePainter::isOfDocument() const {
    return m_view.session().document().dimension() == m_view.dimension();
}

QPolygonF ShapePainter::onScreen(const std::vector<Vec3>& points) const {
    QPolygonF line;
    for (const Vec3& p : points) line << m_view.onScreen(p);
    return line;
}

/// Draws the moving frames of a curve from its actual start, without overlaps.
template <int Dim>
void ShapePainter::frames(const Pin& handle, const Vec<Dim>& start) {
    Vec<Dim> from = start;
    for (const PinMotion& motion : handle.motions) {
        const auto* curve = std::get_if<CurveMotion<3>>(&motion.kind);
        const Trajectory<Dim> trajectory(motionIn<Dim>(motion));
        std::optional<QPointF> last;
        for (int i = 0; curve && curve->frame != FrameKind::None && i < kFramesAlongCurve; ++i) {
            const double t = motion.start + (motion.end - motion.start) * i / (kFramesAlongCurve - 1);
            const Vec3 at = inSpace(trajectory.at(t).position(from));
            const QPointF seen = m_view.onScreen(at);
            if (last && QLineF(*last, seen).length() < marked(kFramesApart)) continue;
            last = seen;
            Mat3 axes = Mat3::Identity();
            axes.topLeftCorner<Dim, Dim>() = trajectory.frame(t);
            frame(at, axes);
        }
        from = trajectory.at(motion.end).position(from);
    }
}

void ShapePainter::frame(const Vec3& at, const Mat3& axes) {
    const double pixel = marked(m_view.pixelSize(at));
    for (int k = 0; k < m_view.dimension(); ++k) {
        const auto [colour, size] = axisOf(m_view.dimension(), k);
        m_marks.line(onScreen({at, at + size * pixel * axes.col(k)}), colour, 1.75, Qt::SolidLine);
    }
}

void ShapePainter::paths(int hovered) {
    if (!isOfDocument()) return;
    m_marks.setQuick(m_view.session().motion().isDragging());
    const double time = m_view.session().playback().time();
    const auto& handles = m_view.session().document().design().handles;
    for (const bool selected : {false, true})
        for (int h = 0; h < static_cast<int>(handles.size()); ++h) {
            if (handles[h].motions.empty() || m_view.session().selection().contains(h) != selected) continue;
            if (handles[h].activeTo <= time || handles[h].traits.hidden) continue;  // released
            const auto starts = shownStarts(m_view.session().pins().pathStarts(h));
            if (starts.empty()) continue;
            for (const PinPath& one : pinPaths(handles[h], starts, m_view.dimension()))
                m_marks.path(onScreen(one.points), one.times, selected, time, h == hovered);
            if (selected)
                isFlat() ? frames<2>(handles[h], inPlane(starts.front()))
                         : frames<3>(handles[h], starts.front());
        }
}

/// Draws the points that a handle of a picture holds.
void ShapePainter::spots(const PinView& pin) {
    const bool selected = m_view.session().selection().contains(pin.handle);
    const QPolygonF places = onScreen(pin.points);
    m_marks.spots({places.begin(), places.end()}, selected ? m_theme.accent : kInk, 3.2, QPen(Qt::white, 1));
}

/// Draws the vertices that a handle of a solid holds where they are visible; of a selected one also hidden
/// ones, faintly.
void ShapePainter::seenSpots(const PinView& pin) {
    const bool selected = m_view.session().selection().contains(pin.handle);
    const double r = selected ? 2.3 : 1.7;
    std::vector<QPointF> seen, hidden;
    for (const VertexMark& mark : m_view.marksOf(m_view.session().pins().verticesOf(pin.handle)))
        (mark.hidden ? hidden : seen).push_back(m_view.onScreen(mark.at));
    QColor fill = selected ? m_theme.accent : kInk;
    fill.setAlpha(70);
    if (selected) m_marks.spots(hidden, fill, r, Qt::NoPen);
    fill.setAlpha(selected ? 255 : 110);
    m_marks.spots(seen, fill, r, selected ? QPen(QColor(255, 255, 255, 190), 0.75) : QPen(Qt::NoPen));
}

/// Draws the outline of a part of a picture that is held as a whole, filled only while the pointer is on it.
void ShapePainter::area(const PinView& pin, bool hovered) {
    const FramePtr frame = m_view.session().motion().frame();
    if (!frame) return;
    const bool selected = m_view.session().selection().contains(pin.handle);
    QPolygonF border =
        onScreen(regionBorder(m_view.session().document().design().handles[pin.handle], pin, *frame));
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

/// Draws the outline of the region of a selected handle of a solid, carried to where its vertices are now.
void ShapePainter::carriedRegion(const PinView& pin) {
    const auto frame = m_view.session().motion().frame<3>();
    const auto* region = std::get_if<Region<3>>(&m_view.session().document().design().handles[pin.handle].at);
    if (!region || !frame || !m_view.session().selection().contains(pin.handle)) return;
    const auto& rest = frame->rest->points;
    std::vector<Vec3> held;
    for (const int v : frame->verticesInside(*region)) held.push_back(frame->restVertex(v));
    const auto carry = carryingBetween<3>(held, pin.points);
    for (auto line : regionOutline(*region, rest.rowwise().minCoeff(), rest.rowwise().maxCoeff())) {
        for (Vec3& p : line) p = carry(p);
        m_marks.line(onScreen(line), m_theme.accent, 1.25, Qt::CustomDashLine);
    }
}

void ShapePainter::pins(int hovered, int named) {
    if (!isOfDocument()) return;
    std::vector<PinView> pins = m_view.session().gestures().pins();
    m_marks.setQuick(m_view.session().motion().isDragging());
    for (const PinView& pin : pins)
        if (pin.region) isFlat() ? area(pin, pin.handle == hovered) : carriedRegion(pin);
    for (const PinView& pin : pins) {
        if (pin.points.size() < 2) continue;
        if (!isFlat()) seenSpots(pin);
        if (isFlat() && !pin.region) spots(pin);
    }
    paintGhosts(hovered, named);
    paintLinks(pins, hovered);
    const auto seen =
        std::ranges::stable_partition(pins, [this](const auto& pin) { return isMarkCovered(m_view, pin); });
    m_painter.setOpacity(kCoveredOpacity);
    for (auto pin = pins.begin(); pin != pins.end(); ++pin) {
        if (pin == seen.begin()) m_painter.setOpacity(1);
        m_marks.pin(m_view.onScreen(pin->centre), lookOf(*pin, hovered));
    }
    m_painter.setOpacity(1);
    for (const PinView& pin : pins)
        if (pin.handle == hovered && pin.handle == named) m_marks.name(m_view.onScreen(pin.centre), pin.name);
}

Marks::Pin ShapePainter::lookOf(const PinView& pin, int hovered) const {
    const Pin& handle = m_view.session().document().design().handles[pin.handle];
    return {m_view.session().selection().contains(pin.handle),
            pin.handle == hovered,
            isFlat() ? pin.region : pin.points.size() > 1,
            !handle.motions.empty() || m_view.session().motion().isDragging(),
            pinColour(pin.handle, handle.traits),
            handle.traits.locked};
}

/// Draws the handles that do not hold at the shown time, below the others.
void ShapePainter::paintGhosts(int hovered, int named) {
    const auto ghosts = m_view.session().gestures().ghosts();
    const auto& handles = m_view.session().document().design().handles;
    for (const PinView& pin : ghosts)
        m_marks.ghost(m_view.onScreen(pin.centre), m_view.session().selection().contains(pin.handle),
                      pin.handle == hovered);
    for (const PinView& pin : ghosts)
        if (pin.handle == hovered && pin.handle == named)
            m_marks.name(m_view.onScreen(pin.centre),
                         ghostName(handles[pin.handle], pin.name, m_view.session().playback().time()));
}

/// Draws lines from each pin that is selected or pointed at to those that move together with it.
void ShapePainter::paintLinks(const std::vector<PinView>& pins, int hovered) {
    const auto& handles = m_view.session().document().design().handles;
    for (const PinView& one : pins) {
        const int link = handles[one.handle].traits.link;
        const bool isShown = one.handle == hovered || m_view.session().selection().contains(one.handle);
        if (link == 0 || !isShown) continue;
        for (const PinView& other : pins)
            if (other.handle != one.handle && handles[other.handle].traits.link == link)
                m_marks.line({m_view.onScreen(one.centre), m_view.onScreen(other.centre)}, kInk, 1,
                             Qt::DotLine);
    }
}

void ShapePainter::groups(const std::vector<GroupMark>& groups) {
    if (!m_view.session().motion().frame()) return;
    for (const GroupMark& group : groups) {
        std::vector<QPointF> places;
        for (const VertexMark& mark : m_view.marksOf(group.vertices))
            if (!mark.hidden) places.push_back(m_view.onScreen(mark.at));
        QColor fill = group.colour;
        fill.setAlpha(group.chosen ? 255 : 150);
        m_marks.spots(places, fill, group.chosen ? 3.4 : 1.8,
                      group.chosen ? QPen(Qt::white, 1) : QPen(Qt::NoPen));
    }
}

/// Draws the points, or an even selection if there are very many.
void ShapePainter::dots(const Points3& points) {
    constexpr Eigen::Index kMost = 20000;
    const Eigen::Index step = std::max<Eigen::Index>(1, points.cols() / kMost);
    std::vector<QPointF> places;
    for (Eigen::Index k = 0; k < points.cols(); k += step) places.push_back(m_view.onScreen(points.col(k)));
    m_marks.spots(places, kInk, 1.4, QPen(QColor(255, 255, 255, 190), 0.6));
}

/// Draws dark rings with light ones around them, which are visible on any colour. A disc gets one ring: its
/// other points would cover each other.
void ShapePainter::joints(const PosedFrame<2>& frame) {
    constexpr double kRadius = 5, kApart = 24;  // pixels of the screen
    QList<QPointF> drawn;
    m_painter.setBrush(Qt::NoBrush);
    for (const Weld& weld : frame.rest->welds) {
        Vec2 place = Vec2::Zero();
        for (const auto& [vertex, weight] : weld.terms)
            if (weight > 0) place += weight * frame.pose.col(vertex);
        const QPointF at = m_view.onScreen(inSpace(place));
        const auto isNear = [&at](const QPointF& other) { return QLineF(at, other).length() < kApart; };
        if (std::ranges::any_of(drawn, isNear)) continue;
        drawn << at;
        for (const auto& [colour, width] :
             {std::pair(QColor(255, 255, 255, 220), 4.0), {QColor(20, 24, 32), 1.6}}) {
            m_painter.setPen(QPen(colour, width));
            m_painter.drawEllipse(at, kRadius, kRadius);
        }
    }
}

void ShapePainter::worst(const ShapeFrame& frame, int cell, const QString& words) {
    if (cell < 0) return;
    const auto place = m_view.placeOf(frame, cell);
    const QPointF at = m_view.onScreen(place ? *place : frame.centreOf(cell));
    m_marks.worst(at, !place);
    if (words.isEmpty()) return;
    const bool isLeft = at.x() > m_painter.viewport().width() / 2.0;  // the side with more room
    paintLabel(m_painter, at + QPointF(isLeft ? -kBeside : kBeside, -kHalfLabel), words, isLeft);
}

void paintFaults(QPainter& painter, ShapeView& view, const PosedFrame<2>& frame,
                 const PoseFaults<2>& faults) {
    Marks marks(painter);
    QColor fill(kWrong);
    fill.setAlphaF(0.75F);
    painter.setPen(Qt::NoPen);
    painter.setBrush(fill);
    const auto at = [&](const Points2& points, int v) { return view.onScreen(inSpace(Vec2(points.col(v)))); };
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
