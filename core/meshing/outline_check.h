#pragma once

#include <array>
#include <vector>

#include "core/meshing/outline.h"

namespace wend {

/// A line segment from a to b.
struct Segment {
    Vec2 a, b;
};

/// Two segments that cross or overlap in more than a common end point.
struct SegmentCrossing {
    std::array<int, 2> segments;  // increasing
    Vec2 place;
};

/// Returns all crossings in the order of the segments. Uses exact predicates. Segments that only touch do not
/// cross. Takes about O(n log n) plus the pairs whose boxes intersect. The place is that of the crossing, or
/// the middle of an overlap, rounded.
std::vector<SegmentCrossing> crossingsOf(const std::vector<Segment>& segments);

/// Returns the outline without repeated consecutive points. Throws InputError that names polygon, point or
/// place for: no polygon; a coordinate that is not finite; fewer than three distinct points; no area.
Outline cleanedOutline(const Outline& outline);

/// Throws InputError with the place of the first two edges that cross.
void requireNoCrossing(const Outline& outline);

/// Returns the outline through all points that are within `tolerance` of it: corners that close are moved
/// onto the point, otherwise the nearest edge is split there.
Outline outlineThrough(Outline outline, const std::vector<Vec2>& points, double tolerance);

}  // namespace wend
