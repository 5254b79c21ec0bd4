#pragma once

#include "warp/plane_map.h"

namespace wend {

/// Returns a path that is carried by a map: cubics that keep within `tolerance` of it at all places that are
/// looked at, eight for each and two for each cell that it crosses. Smooth places stay smooth, corners stay
/// corners, and lines that are straight after the map stay lines. What closes a curve is carried, too.
SvgPath carriedPath(const SvgPath& path, const PlaneMap& map, double tolerance);

}  // namespace wend
