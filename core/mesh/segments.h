#pragma once

#include <vector>

#include "core/base/types.h"

namespace wend {

/// Returns the point of the segment a → b (possibly degenerate) nearest to p. It works in 4D as well, for
/// paths in space and time.
template <int Dim>
Vec<Dim> nearestOnSegment(const Vec<Dim>& p, const Vec<Dim>& a, const Vec<Dim>& b);
/// Returns the distance of p from the segment a → b.
template <int Dim>
double distanceToSegment(const Vec<Dim>& p, const Vec<Dim>& a, const Vec<Dim>& b);

/// Returns whether the segment a → b crosses the ray from p in positive x direction: p is inside a boundary
/// with an odd number of crossings. Half-open in y, so that a ray through a corner counts once.
bool crossesRay(const Vec2& a, const Vec2& b, const Vec2& p);

/// Returns the signed area of a closed loop by the shoelace formula. It is positive for counter-clockwise
/// loops in (x, y). Products are relative to the first point, so that a loop far from the origin keeps its
/// digits; 0 for fewer than three points.
double loopArea(const std::vector<Vec2>& loop);

}  // namespace wend
