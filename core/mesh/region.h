#pragma once

#include <limits>
#include <variant>
#include <vector>

#include "core/base/types.h"

namespace wend {

/// Shapes that name a part of the plane or of space; used by handles and by the material.
struct Polygon {  // in space an infinite prism along z
    std::vector<Vec2> points;
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
using Region = std::variant<Polygon, Ball<Dim>, Box<Dim>, HalfSpace<Dim>, Blend<Dim>>;

/// Returns the region of the plane z = 0 that is written in the coordinates of space.
Region<2> inPlane(const Region<3>& region);
/// Returns a region of the plane in the coordinates of space, with z = 0.
Region<3> inSpace(const Region<2>& region);
inline const Region<3>& inSpace(const Region<3>& region) {
    return region;
}

/// Returns the region in the coordinates of that dimension.
template <int Dim>
Region<Dim> regionIn(const Region<3>& region) {
    if constexpr (Dim == 3)
        return region;
    else
        return inPlane(region);
}

/// Returns the signed distance to the boundary of the region, negative inside. A polygon is inside by the
/// even–odd rule, and has +infinity without points; a half-space without a normal holds nothing, +infinity; a
/// Blend has no boundary, −infinity. The corners of a box may be given in any order.
template <int Dim>
double signedDistance(const Region<Dim>& region, const Vec<Dim>& p);

/// Returns the membership of p in the region, in [0, 1]: 1 inside, 0 outside, and over the width `feather`,
/// centred on the boundary, 3t² − 2t³ with t = ½ − distance / feather, which is C¹ and ½ on the boundary.
/// Without a feather the boundary is inside. For a Blend it is the parameter along its segment, clamped to
/// [0, 1]; 0 if both ends coincide.
template <int Dim>
double membership(const Region<Dim>& region, const Vec<Dim>& p, double feather);

}  // namespace wend
