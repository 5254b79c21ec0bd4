#pragma once

#include <limits>
#include <variant>
#include <vector>

#include "core/base/types.h"

namespace wend {

/// Shapes that name a part of the plane or of space; used by handles and by the material.
struct Polygon {
    std::vector<Vec<2>> points;
    bool operator==(const Polygon&) const = default;
};
/// A disc or ball.
template <int Dim>
struct Ball {  // "circle" in 2D, "sphere" in 3D
    Vec<Dim> centre;
    double radius = 0;
    bool operator==(const Ball&) const = default;
};
/// An axis-aligned box, with its boundary.
template <int Dim>
struct Box {
    Vec<Dim> min, max;
    bool operator==(const Box&) const = default;
};
/// The side of a line or plane.
template <int Dim>
struct HalfSpace {  // the side that the normal points away from is outside
    Vec<Dim> point, normal;
    bool operator==(const HalfSpace&) const = default;
};
/// The whole domain with a linear amount from 0 at `from` to 1 at `to` along the segment.
template <int Dim>
struct Blend {
    Vec<Dim> from, to;
    bool operator==(const Blend&) const = default;
};

template <int Dim>
struct RegionOf;
template <>
struct RegionOf<2> {
    using Type = std::variant<Polygon, Ball<2>, Box<2>, HalfSpace<2>, Blend<2>>;
};
template <>
struct RegionOf<3> {
    using Type = std::variant<Ball<3>, Box<3>, HalfSpace<3>, Blend<3>>;
};
template <int Dim>
using Region = typename RegionOf<Dim>::Type;

/// Returns the signed distance to the boundary of the region, negative inside; −infinity for a Blend, which
/// has none.
template <int Dim>
double signedDistance(const Region<Dim>& region, const Vec<Dim>& p);

/// Returns the membership of p in the region, in [0, 1]: 1 inside, 0 outside, smooth (C¹) over the width
/// `feather` centred on the boundary; for a Blend the parameter along its segment, clamped to [0, 1].
template <int Dim>
double membership(const Region<Dim>& region, const Vec<Dim>& p, double feather);

}  // namespace wend
