#include "app/tools/pins/held_part.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>
#include <iterator>

#include "app/engine/motion/places.h"
#include "app/project/design.h"
#include "app/project/domain.h"
#include "app/project/edits/handle_edits.h"
#include "app/session/shape_session.h"
#include "app/style/colours.h"
#include "app/style/marks.h"
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
Polygon atRest(PictureShapeView& view, const QPolygonF& outline) {
    const auto frame = view.session().motion().frame<2>();
    const PointLocator<2> locator(frame->pose, frame->rest->cells);
    const Points2& rest = frame->rest->points;
    std::vector<Vec2> points;
    for (const QPointF& corner : refined(outline)) {
        const Vec2 p = view.toShape(corner);
        if (const auto location = locator.find(p)) {
            points.push_back(positionOf<2>(*location, *frame->rest, rest));
            continue;
        }
        Eigen::Index nearest = 0;
        (frame->pose.colwise() - p).colwise().squaredNorm().minCoeff(&nearest);
        points.push_back(rest.col(nearest) + p - frame->pose.col(nearest));
    }
    const double pixel = (view.toShape({1, 0}) - view.toShape({0, 0})).norm();
    points.push_back(points.front());
    points = simplified<2>(points, kPartDetail * pixel);
    points.pop_back();
    return {points};
}

/// Returns the placement of the handle; nothing if it contains (almost) nothing of the shape.
std::optional<Placement<3>> placementOf(PictureShapeView& view, const QPainterPath& area) {
    const QPolygonF outline = outlineOf(area);
    const Polygon polygon = outline.size() < 3 ? Polygon() : atRest(view, outline);
    if (polygon.points.size() < 3 ||
        view.session().motion().frame()->verticesInside(polygon).size() < kMinHeld)
        return {};
    return Region<3>(polygon);
}

/// Returns the part of a picture to which a handle belongs that holds this: where parts are locked, the
/// frontmost other one that has vertices there. Empty: any part. Nothing if all that it would hold is locked.
std::optional<std::string> ownerOf(ShapeView& view, const Placement<3>& placement) {
    const auto& parts = view.session().document().domain().parts;
    const auto* region = std::get_if<Region<3>>(&placement);
    if (!region || std::ranges::none_of(parts, &PicturePart::locked)) return std::string();
    const FramePtr frame = view.session().motion().frame();
    const std::vector<int> held = frame->verticesInside(*region);
    for (auto range = frame->parts().rbegin(); range != frame->parts().rend(); ++range) {
        const auto part = std::ranges::find(parts, range->name, &PicturePart::name);
        if (part != parts.end() && part->locked) continue;
        const auto first = std::ranges::lower_bound(held, range->firstVertex);
        if (first != held.end() && *first < range->endVertex) return range->name;
    }
    return {};
}

std::optional<Placement<3>> placementOf(SolidShapeView& view, const std::vector<int>& vertices) {
    if (vertices.empty()) return {};
    return view.session().pins().placementOf(vertices);
}

/// Returns what the single selected handle holds; nothing without one, or in the plane if that is no region.
std::optional<QPainterPath> selectedPart(PictureShapeView& view) {
    const ShapeMotion& motion = view.session().motion();
    for (const PinView& pin : view.session().gestures().pins()) {
        if (pin.handle != view.session().selection().single() || !pin.region) continue;
        QPolygonF border;
        for (const Vec3& p :
             regionBorder(motion.document().design().handles[pin.handle], pin, *motion.frame()))
            border << view.onScreen(p);
        return snapped(insideOf(border));
    }
    return {};
}

std::optional<std::vector<int>> selectedPart(SolidShapeView& view) {
    const int handle = view.session().selection().single();
    if (handle < 0) return {};
    return view.session().pins().verticesOf(handle);
}

QPainterPath united(const QPainterPath& a, const QPainterPath& b) {
    return a.united(b);
}

std::vector<int> united(const std::vector<int>& a, const std::vector<int>& b) {
    return joined(a, b);
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

QPainterPath drawnPart(const PictureShapeView&, const DrawnOutline& outline) {
    return snapped(outline.area());
}

std::vector<int> drawnPart(const SolidShapeView& view, const DrawnOutline& outline, bool through) {
    auto vertices = view.verticesWhere([&](const QPointF& p) { return outline.contains(p); }, !through);
    std::ranges::sort(vertices);
    return vertices;
}

namespace {

template <class View, class Part>
bool hold(View& view, const Part& part) {
    const auto place = placementOf(view, part);
    if (const auto owner = place ? ownerOf(view, *place) : std::nullopt)
        return view.session().addHandle(*place, QCoreApplication::translate("GrabTool", "Part").toStdString(),
                                        *owner) >= 0;
    Document& document = view.session().document();
    document.notify(QCoreApplication::translate("GrabTool", "No part of the shape lies in this outline."));
    return false;
}

template <class View, class Part>
bool change(View& view, const Part& part, Qt::KeyboardModifiers with) {
    const bool adds = with & Qt::ShiftModifier, takes = with & Qt::ControlModifier;
    const auto own = adds || takes ? selectedPart(view) : std::nullopt;
    if (!own && takes && !adds)
        view.session().document().notify(
            QCoreApplication::translate("GrabTool", "Select one part to take away from."));
    if (!own) return takes && !adds;
    const Part changed = adds ? united(*own, part) : without(*own, part);
    if (changed == *own) return true;
    if (const auto place = placementOf(view, changed))
        view.session().changeHandle(view.session().selection().single(), *place);
    else
        view.session().document().notify(
            QCoreApplication::translate("GrabTool", "A handle must hold something; Delete removes it."));
    return true;
}

}  // namespace

bool holdPart(PictureShapeView& view, const QPainterPath& part) {
    return hold(view, part);
}
bool holdPart(SolidShapeView& view, const std::vector<int>& part) {
    return hold(view, part);
}
bool changePart(PictureShapeView& view, const QPainterPath& part, Qt::KeyboardModifiers with) {
    return change(view, part, with);
}
bool changePart(SolidShapeView& view, const std::vector<int>& part, Qt::KeyboardModifiers with) {
    return change(view, part, with);
}

void paintCaught(QPainter& painter, SolidShapeView& view, const std::vector<int>& vertices,
                 const QPointF& at) {
    const auto frame = view.session().motion().frame<3>();
    if (!frame) return;
    painter.setBrush(QColor(kAccent));
    painter.setPen(QPen(Qt::white, marked(0.75)));
    for (const int v : vertices)
        painter.drawEllipse(view.onScreen(frame->vertex(v)), marked(2.6), marked(2.6));
    paintLabel(painter, at + QPointF(16, 12),
               QCoreApplication::translate("wend::RegionPanel", "Vertices: %n", nullptr,
                                           static_cast<int>(vertices.size())));
}

}  // namespace wend
