#include "core/mesh/region.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "core/mesh/segments.h"

namespace wend {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Returns the signed distance by the even–odd rule: a point is inside if a ray from it crosses the boundary
/// an odd number of times.
template <int Dim>
double distanceOf(const Polygon& polygon, const Vec<Dim>& at) {
    const Vec2 p = at.template head<2>();
    const auto& points = polygon.points;
    double nearest = infinity;
    bool inside = false;
    for (std::size_t i = 0, previous = points.size() - 1; i < points.size(); previous = i++) {
        nearest = std::min(nearest, distanceToSegment<2>(p, points[previous], points[i]));
        if (crossesRay(points[previous], points[i], p)) inside = !inside;
    }
    return inside ? -nearest : nearest;
}

template <int Dim>
double distanceOf(const Ball<Dim>& ball, const Vec<Dim>& p) {
    return (p - ball.centre).norm() - ball.radius;
}

template <int Dim>
double distanceOf(const Box<Dim>& box, const Vec<Dim>& p) {
    const Vec<Dim> low = box.min.cwiseMin(box.max), high = box.min.cwiseMax(box.max);
    const Vec<Dim> beyond = (low - p).cwiseMax(p - high);
    return beyond.maxCoeff() > 0 ? beyond.cwiseMax(0.0).norm() : beyond.maxCoeff();
}

/// The normal points inwards; a zero normal bounds nothing: everything is outside.
template <int Dim>
double distanceOf(const HalfSpace<Dim>& half, const Vec<Dim>& p) {
    const double length = half.normal.stableNorm();
    return length > 0 ? (half.point - p).dot(half.normal / length) : infinity;
}

template <int Dim>
double distanceOf(const Blend<Dim>&, const Vec<Dim>&) {
    return -infinity;
}

template <int Dim>
double alongBlend(const Blend<Dim>& blend, const Vec<Dim>& p) {
    const Vec<Dim> along = blend.to - blend.from;
    const double lengthSquared = along.squaredNorm();
    return lengthSquared > 0 ? std::clamp(along.dot(p - blend.from) / lengthSquared, 0.0, 1.0) : 0.0;
}

/// Returns 3t² − 2t³ over the width, ½ on the boundary.
double smoothEdge(double distance, double feather) {
    const double t = std::clamp(0.5 - distance / feather, 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

}  // namespace

template <int Dim>
double signedDistance(const Region<Dim>& region, const Vec<Dim>& p) {
    return std::visit(
        [&](const auto& shape) {
            if constexpr (std::is_same_v<decltype(shape), const Polygon&>)
                return distanceOf<Dim>(shape, p);
            else
                return distanceOf(shape, p);
        },
        region);
}

template <int Dim>
double membership(const Region<Dim>& region, const Vec<Dim>& p, double feather) {
    if (const auto* blend = std::get_if<Blend<Dim>>(&region)) return alongBlend<Dim>(*blend, p);
    const double distance = signedDistance<Dim>(region, p);
    if (feather > 0) return smoothEdge(distance, feather);
    return distance <= 0 ? 1 : 0;
}

namespace {

/// Converts the shapes of regions by a map of their points and vectors.
template <int To, class Map>
struct Converted {
    Map map;

    Region<To> operator()(const Polygon& polygon) const { return polygon; }
    template <int From>
    Region<To> operator()(const Ball<From>& ball) const {
        return Ball<To>{map(ball.centre), ball.radius};
    }
    template <int From>
    Region<To> operator()(const Box<From>& box) const {
        return Box<To>{map(box.min), map(box.max)};
    }
    template <int From>
    Region<To> operator()(const HalfSpace<From>& half) const {
        return HalfSpace<To>{map(half.point), map(half.normal)};
    }
    template <int From>
    Region<To> operator()(const Blend<From>& blend) const {
        return Blend<To>{map(blend.from), map(blend.to)};
    }
};

}  // namespace

Region<2> inPlane(const Region<3>& region) {
    const auto map = [](const Vec3& p) { return inPlane(p); };
    return std::visit(Converted<2, decltype(map)>{map}, region);
}

Region<3> inSpace(const Region<2>& region) {
    const auto map = [](const Vec2& p) { return inSpace(p); };
    return std::visit(Converted<3, decltype(map)>{map}, region);
}

#define WEND_INSTANTIATE(Dim)                                                 \
    template double signedDistance<Dim>(const Region<Dim>&, const Vec<Dim>&); \
    template double membership<Dim>(const Region<Dim>&, const Vec<Dim>&, double);
WEND_INSTANTIATE(2)
WEND_INSTANTIATE(3)

}  // namespace wend
