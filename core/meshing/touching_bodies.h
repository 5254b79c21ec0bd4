#pragma once

#include "core/base/message.h"
#include "core/meshing/surface.h"

namespace wend {

/// Returns the components that only touch each other: of none of their pairs of triangles that intersect do
/// both reach to both sides of the other's plane, by more than a millionth of the surface's extent. Two
/// bodies with one pair of triangles that cross are not among them.
std::vector<TouchingBodies> touchingBodies(const Surface& surface,
                                           const std::vector<std::array<int, 2>>& intersecting);

/// Describes them: "bodies 1 and 2 touch along a face whose triangles do not match (near 1 0.5 0.5): give
/// both the same triangles there or leave a gap".
Message textOf(const TouchingBodies& touching);

}  // namespace wend
