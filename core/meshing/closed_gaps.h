#pragma once

#include <cstdint>
#include <stop_token>
#include <vector>

#include "core/meshing/surface.h"

namespace wend {

class CubeGrid;

/// A gap within one part of a surface that a cage closes, so that both sides move together.
struct ClosedGap {
    double width = 0;
    Vec3 place = Vec3::Zero();  // in the middle of it, where it is narrowest
    double cubeAcross = 1;  // how long a cube is across it, in its edges: up to √3 where the gap is oblique
};

/// Returns gaps of at most `widest` that the full cubes (in increasing order) close, narrowest first: pairs
/// of sides that face each other across the outside of the surface, and are much farther apart along it than
/// across. Outside is where normals point to, or come from for an inverted part. The surface must be finite
/// with valid vertices. Throws Cancelled.
std::vector<ClosedGap> closedGaps(const Surface& surface, const CubeGrid& grid,
                                  const std::vector<std::int64_t>& full, double widest,
                                  const std::stop_token& stop);

}  // namespace wend
