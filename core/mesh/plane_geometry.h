#pragma once

#include <vector>

#include "core/mesh/types.h"

namespace wend {

/// The point of the segment a → b (which may be a point) that is nearest to p, and how far that is.
Vec<2> nearestOnSegment(const Vec<2>& p, const Vec<2>& a, const Vec<2>& b);
double distanceToSegment(const Vec<2>& p, const Vec<2>& a, const Vec<2>& b);

/// Signed area of a closed loop (shoelace).
double loopArea(const std::vector<Vec<2>>& loop);

}  // namespace wend
