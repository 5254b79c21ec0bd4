#pragma once

#include <vector>

#include "core/mesh/types.h"

namespace wend {

/// The point of the segment a → b (which may be a point) that is nearest to p, and how far that is. In 4D for
/// ways in space and time.
template <int Dim>
Vec<Dim> nearestOnSegment(const Vec<Dim>& p, const Vec<Dim>& a, const Vec<Dim>& b);
template <int Dim>
double distanceToSegment(const Vec<Dim>& p, const Vec<Dim>& a, const Vec<Dim>& b);

/// True if the segment a → b crosses the ray from p towards greater x: p is inside a boundary that an odd
/// number of whose segments do. Half-open in y, so that a ray through a corner counts once.
bool crossesRay(const Vec<2>& a, const Vec<2>& b, const Vec<2>& p);

/// Signed area of a closed loop (shoelace).
double loopArea(const std::vector<Vec<2>>& loop);

}  // namespace wend
