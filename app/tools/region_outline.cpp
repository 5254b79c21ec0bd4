#include "app/tools/region_outline.h"

#include <Eigen/Geometry>
#include <QPainter>
#include <cmath>
#include <numbers>

#include "app/engine/motion/places.h"
#include "app/session/shape_session.h"

namespace wend {

namespace {

using Lines = std::vector<std::vector<Vec3>>;
constexpr int kCirclePieces = 48;

Lines linesOf(const Ball<3>& ball, const Vec3&, const Vec3&) {
    Lines lines;
    for (int axis = 0; axis < 3; ++axis) {
        std::vector<Vec3> ring;
        const Vec3 u = Vec3::Unit((axis + 1) % 3), v = Vec3::Unit((axis + 2) % 3);
        for (int i = 0; i <= kCirclePieces; ++i) {
            const double a = 2 * std::numbers::pi * i / kCirclePieces;
            ring.push_back(ball.centre + ball.radius * (std::cos(a) * u + std::sin(a) * v));
        }
        lines.push_back(std::move(ring));
    }
    return lines;
}

Lines linesOf(const Box<3>& box, const Vec3&, const Vec3&) {
    const auto corner = [&box](int i) {
        return Vec3(i & 1 ? box.max.x() : box.min.x(), i & 2 ? box.max.y() : box.min.y(),
                    i & 4 ? box.max.z() : box.min.z());
    };
    Lines lines;
    for (int i = 0; i < 8; ++i)
        for (const int bit : {1, 2, 4})
            if (!(i & bit)) lines.push_back({corner(i), corner(i | bit)});
    return lines;
}

Lines linesOf(const HalfSpace<3>& half, const Vec3& low, const Vec3& high) {
    if (half.normal.norm() == 0) return {};
    const Vec3 n = half.normal.normalized(), u = n.unitOrthogonal(), v = n.cross(u),
               middle = (low + high) / 2;
    const Vec3 centre = middle + n.dot(half.point - middle) * n;
    const double reach = 0.4 * (high - low).norm();
    const Vec3 tip = centre + 0.35 * reach * n, back = tip - 0.1 * reach * n;
    return {{centre + reach * (u + v), centre + reach * (u - v), centre - reach * (u + v),
             centre - reach * (u - v), centre + reach * (u + v)},
            {centre, tip},
            {back + 0.05 * reach * u, tip, back - 0.05 * reach * u}};
}

Lines linesOf(const Polygon&, const Vec3&, const Vec3&) {
    return {};  // of pictures only
}

Lines linesOf(const Blend<3>& blend, const Vec3&, const Vec3&) {
    return {{blend.from, blend.to}};
}

std::vector<Vec2> borderOf(const Polygon& polygon) {
    return polygon.points;
}
std::vector<Vec2> borderOf(const Ball<2>& ball) {
    std::vector<Vec2> ring;
    for (int i = 0; i < kCirclePieces; ++i) {
        const double a = 2 * std::numbers::pi * i / kCirclePieces;
        ring.push_back(ball.centre + ball.radius * Vec2(std::cos(a), std::sin(a)));
    }
    return ring;
}
std::vector<Vec2> borderOf(const Box<2>& box) {
    return {box.min, {box.max.x(), box.min.y()}, box.max, {box.min.x(), box.max.y()}};
}
template <class Endless>
std::vector<Vec2> borderOf(const Endless&) {
    return {};
}

/// Returns the part of a polygon where n·p ≤ d.
std::vector<Vec2> clipped(const std::vector<Vec2>& polygon, const Vec2& n, double d) {
    std::vector<Vec2> part;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec2 &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
        const double from = d - n.dot(p), to = d - n.dot(q);
        if (from >= 0) part.push_back(p);
        if ((from < 0) != (to < 0)) part.emplace_back(p + from / (from - to) * (q - p));
    }
    return part;
}

/// Shrinks a drawn outline towards its contents: it may be much larger than the part that it holds.
std::vector<Vec2> aroundHeld(std::vector<Vec2> border, const std::vector<Vec2>& held) {
    if (held.empty()) return border;
    Vec2 low = held.front(), high = low;
    for (const Vec2& p : held) low = low.cwiseMin(p), high = high.cwiseMax(p);
    const double spacing = std::sqrt((high - low).prod() / static_cast<double>(held.size()));
    for (const int k : {0, 1}) {
        border = clipped(border, Vec2::Unit(k), high[k] + spacing);
        border = clipped(border, -Vec2::Unit(k), spacing - low[k]);
    }
    return border;
}

}  // namespace

std::vector<Vec3> regionBorder(const Pin& handle, const PinView& view, const ShapeFrame& frame) {
    std::vector<Vec2> points, border, held;
    for (const Vec3& p : view.points) points.push_back(inPlane(p));
    const auto* spatial = std::get_if<Region<3>>(&handle.at);
    if (spatial) {
        const Region<2> region = inPlane(*spatial);
        for (const int v : frame.verticesInside(*spatial)) held.push_back(inPlane(frame.restVertex(v)));
        border = std::visit([](const auto& shape) { return borderOf(shape); }, region);
        if (!std::holds_alternative<Ball<2>>(region)) border = aroundHeld(std::move(border), held);
    }
    if (border.empty()) return inSpace(convexHull(points));
    const auto carry = carryingBetween<2>(held, points);
    for (Vec2& p : border) p = carry(p);
    return inSpace(border);
}

void paintRegions(QPainter& painter, ShapeView& view, const std::vector<Region<3>>& regions,
                  const QPen& pen) {
    const auto frame = view.session().motion().frame<3>();
    if (!frame) return;
    painter.setPen(pen);
    painter.setBrush(Qt::NoBrush);
    const Points3& rest = frame->rest->points;
    for (const Region<3>& region : regions) {
        const auto carry = carryingOf(*frame, frame->verticesInside(region));
        const auto* ball = std::get_if<Ball<3>>(&region);
        if (ball && regions.size() > 1) {
            const Vec3 centre = carry(ball->centre);
            const double r = ball->radius / view.pixelSize(centre);
            painter.drawEllipse(view.onScreen(centre), r, r);
            continue;
        }
        for (const auto& line : regionOutline(region, rest.rowwise().minCoeff(), rest.rowwise().maxCoeff())) {
            QPolygonF drawn;
            for (const Vec3& p : line) drawn << view.onScreen(carry(p));
            painter.drawPolyline(drawn);
        }
    }
}

std::vector<std::vector<Vec3>> regionOutline(const Region<3>& region, const Vec3& low, const Vec3& high) {
    return std::visit([&](const auto& shape) { return linesOf(shape, low, high); }, region);
}

}  // namespace wend
