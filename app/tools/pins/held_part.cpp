#include "app/tools/pins/held_part.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>
#include <iterator>

#include "app/engine/motion/pose_places.h"
#include "app/project/design.h"
#include "app/project/domain.h"
#include "app/project/edits/handle_edits.h"
#include "app/style/colours.h"
#include "app/style/mark_size.h"
#include "app/tools/drag_label.h"
#include "app/tools/region_outline.h"

namespace wend {

namespace {

constexpr double kPartDetail = 0.75;  // pixels of the screen that an outline may deviate
constexpr double kLongestEdge = 12;   // pixels of the screen: the shape may be bent under it
constexpr std::size_t kMinHeld = 3;   // vertices

double sizeOf(const QPolygonF& polygon) {
    double twice = 0;
    for (qsizetype i = 0; i < polygon.size(); ++i) {
        const QPointF &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        twice += a.x() * b.y() - b.x() * a.y();
    }
    return std::abs(twice) / 2;
}

/// Returns the largest piece of an area, without its holes.
QPolygonF outlineOf(const QPainterPath& area) {
    QPolygonF best;
    for (const QPolygonF& piece : area.simplified().toSubpathPolygons())
        if (sizeOf(piece) > sizeOf(best)) best = piece;
    return best;
}

/// Returns the same outline with no edge longer than kLongestEdge.
QPolygonF refined(const QPolygonF& outline) {
    QPolygonF result;
    for (qsizetype i = 0; i < outline.size(); ++i) {
        const QPointF a = outline[i], b = outline[(i + 1) % outline.size()];
        const int pieces = std::max(1, static_cast<int>(std::ceil(QLineF(a, b).length() / kLongestEdge)));
        for (int k = 0; k < pieces; ++k) result << a + (b - a) * k / pieces;
    }
    return result;
}

/// Snaps to half pixels, because unions of paths with nearly coincident edges lose parts.
QPainterPath snapped(const QPainterPath& path) {
    QPainterPath result;
    result.setFillRule(Qt::WindingFill);
    for (QPolygonF piece : path.simplified().toSubpathPolygons()) {
        for (QPointF& p : piece) p = QPointF(std::round(2 * p.x()), std::round(2 * p.y())) / 2;
        result.addPolygon(piece);
        result.closeSubpath();
    }
    return result;
}

/// Maps an outline to the rest shape: outside of it by the offset from the nearest vertex.
Polygon atRest(ToolSurface& surface, const QPolygonF& outline) {
    const auto frame = surface.session().frame<2>();
    const PointLocator<2> locator(frame->pose, frame->rest->cells);
    const Points<2>& rest = frame->rest->points;
    std::vector<Vec<2>> points;
    for (const QPointF& corner : refined(outline)) {
        const Vec<2> p = surface.toShape(corner);
        if (const auto location = locator.find(p)) {
            points.push_back(positionOf<2>(*location, *frame->rest, rest));
            continue;
        }
        Eigen::Index nearest = 0;
        (frame->pose.colwise() - p).colwise().squaredNorm().minCoeff(&nearest);
        points.push_back(rest.col(nearest) + p - frame->pose.col(nearest));
    }
    const double pixel = (surface.toShape({1, 0}) - surface.toShape({0, 0})).norm();
    points.push_back(points.front());
    points = simplified<2>(points, kPartDetail * pixel);
    points.pop_back();
    return {points};
}

/// Returns the placement of the handle; nothing if it contains (almost) nothing of the shape.
std::optional<Placement<2>> placementOf(ToolSurface& surface, const QPainterPath& area) {
    const QPolygonF outline = outlineOf(area);
    const Polygon polygon = outline.size() < 3 ? Polygon() : atRest(surface, outline);
    const auto& rest = *surface.session().frame<2>()->rest;
    if (polygon.points.size() < 3 || verticesInside<2>(polygon, rest).size() < kMinHeld) return {};
    return Region<2>(polygon);
}

/// Returns the part of a picture to which a handle belongs that holds this: where parts are locked, the
/// frontmost other one that has vertices there. Empty: any part. Nothing if all that it would hold is locked.
std::optional<std::string> ownerOf(ToolSurface& surface, const Placement<2>& placement) {
    const auto& parts = surface.session().document().domain().parts;
    const auto* region = std::get_if<Region<2>>(&placement);
    if (!region || std::ranges::none_of(parts, &PicturePart::locked)) return std::string();
    const SimplicialMesh<2>& rest = *surface.session().frame<2>()->rest;
    for (auto range = rest.parts.rbegin(); range != rest.parts.rend(); ++range) {
        const auto part = std::ranges::find(parts, range->name, &PicturePart::name);
        if (part != parts.end() && part->locked) continue;
        for (int v = range->firstVertex; v < range->endVertex; ++v)
            if (signedDistance<2>(*region, rest.points.col(v)) <= 0) return range->name;
    }
    return {};
}

std::optional<std::string> ownerOf(SolidSurface&, const Placement<3>&) {
    return std::string();
}

std::optional<Placement<3>> placementOf(SolidSurface& surface, const std::vector<int>& vertices) {
    if (vertices.empty()) return {};
    return surface.session().placementOf(vertices);
}

/// Returns what the single selected handle holds; nothing without one, or in the plane if that is no region.
std::optional<QPainterPath> selectedPart(ToolSurface& surface) {
    ShapeSession& session = surface.session();
    const auto frame = session.frame<2>();
    for (const PinView<2>& view : session.pins()) {
        if (view.handle != session.singleHandle() || !view.region) continue;
        QPolygonF border;
        for (const Vec<2>& p : regionBorder(session.document().design().handles[view.handle], view, *frame))
            border << surface.toWidget(p);
        return snapped(insideOf(border));
    }
    return {};
}

std::optional<std::vector<int>> selectedPart(SolidSurface& surface) {
    const int handle = surface.session().singleHandle();
    if (handle < 0) return {};
    return surface.session().verticesOf(handle);
}

QPainterPath joined(const QPainterPath& a, const QPainterPath& b) {
    return a.united(b);
}

QPainterPath without(const QPainterPath& a, const QPainterPath& b) {
    return a.subtracted(b);
}

std::vector<int> without(const std::vector<int>& a, const std::vector<int>& b) {
    std::vector<int> rest;
    std::ranges::set_difference(a, b, std::back_inserter(rest));
    return rest;
}

}  // namespace

std::vector<int> joined(const std::vector<int>& a, const std::vector<int>& b) {
    std::vector<int> both;
    std::ranges::set_union(a, b, std::back_inserter(both));
    return both;
}

template <>
QPainterPath drawnPart<2>(const ToolSurface&, const DrawnOutline& outline, bool) {
    return snapped(outline.area());
}

template <>
std::vector<int> drawnPart<3>(const SolidSurface& surface, const DrawnOutline& outline, bool through) {
    auto vertices = surface.verticesWhere([&](const QPointF& p) { return outline.contains(p); }, !through);
    std::ranges::sort(vertices);
    return vertices;
}

template <int Dim>
bool holdPart(SurfaceOf<Dim>& surface, const HeldPart<Dim>& part) {
    ShapeSession& session = surface.session();
    const auto place = placementOf(surface, part);
    if (const auto owner = place ? ownerOf(surface, *place) : std::nullopt)
        return session.addHandle<Dim>(*place, QCoreApplication::translate("GrabTool", "Part").toStdString(),
                                      *owner) >= 0;
    session.notify(QCoreApplication::translate("GrabTool", "No part of the shape lies in this outline."));
    return false;
}

template <int Dim>
bool changePart(SurfaceOf<Dim>& surface, const HeldPart<Dim>& part, Qt::KeyboardModifiers with) {
    const bool adds = with & Qt::ShiftModifier, takes = with & Qt::ControlModifier;
    ShapeSession& session = surface.session();
    const auto own = adds || takes ? selectedPart(surface) : std::nullopt;
    if (!own && takes && !adds)
        session.notify(QCoreApplication::translate("GrabTool", "Select one part to take away from."));
    if (!own) return takes && !adds;
    const auto changed = adds ? joined(*own, part) : without(*own, part);
    if (changed == *own) return true;
    if (const auto place = placementOf(surface, changed))
        session.changeHandle<Dim>(session.singleHandle(), *place);
    else
        session.notify(
            QCoreApplication::translate("GrabTool", "A handle must hold something; Delete removes it."));
    return true;
}

void paintCaught(QPainter& painter, SolidSurface& surface, const std::vector<int>& vertices,
                 const QPointF& at) {
    const auto frame = surface.session().frame<3>();
    if (!frame) return;
    painter.setBrush(QColor(kAccent));
    painter.setPen(QPen(Qt::white, marked(0.75)));
    for (const int v : vertices)
        painter.drawEllipse(surface.toWidget(frame->pose.col(v)), marked(2.6), marked(2.6));
    paintLabel(painter, at + QPointF(16, 12),
               QCoreApplication::translate("wend::RegionPanel", "Vertices: %n", nullptr,
                                           static_cast<int>(vertices.size())));
}

#define WEND_INSTANTIATE(Dim)                                           \
    template bool holdPart<Dim>(SurfaceOf<Dim>&, const HeldPart<Dim>&); \
    template bool changePart<Dim>(SurfaceOf<Dim>&, const HeldPart<Dim>&, Qt::KeyboardModifiers)

WEND_INSTANTIATE(2);
WEND_INSTANTIATE(3);
#undef WEND_INSTANTIATE

}  // namespace wend
