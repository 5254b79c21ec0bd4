#pragma once

#include <string>

#include "core/meshing/outline.h"

namespace wend {

/// The outline without repeated consecutive points. Throws InputError naming polygon, point or place: no
/// polygon; a coordinate that is not finite; fewer than three distinct points; no area.
Outline cleanedOutline(const Outline& outline);

/// Throws InputError with the place where two edges cross, or run over each other, in more than a common
/// point. Exact predicates.
void requireNoCrossing(const Outline& outline);

/// The outline through all points that are within `tolerance` of it: corners that close are moved onto the
/// point, otherwise the nearest edge is split there.
Outline outlineThrough(Outline outline, const std::vector<Vec<2>>& points, double tolerance);

}  // namespace wend
