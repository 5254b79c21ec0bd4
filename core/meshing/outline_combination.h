#pragma once

#include "core/meshing/outline.h"

namespace wend {

/// Selects the area that remains: that in either outline, in the base only, or in both.
enum class OutlineOperation { Add, TakeAway, Keep };  // union, difference, intersection

/// Combines two outlines, each with the even-odd rule; they may touch and cross themselves and each other in
/// any way (CGAL, exact intersections). New corners are rounded to a grid of 2⁻¹² units; parts and holes
/// smaller than `smallest` in area are dropped. The resulting loops do not cross, outer ones are
/// counter-clockwise in (x, y), holes clockwise. The result may be empty. Throws InputError for non-finite
/// input.
Outline combined(const Outline& base, const Outline& piece, OutlineOperation operation, double smallest = 0);

/// Returns the area of the even-odd inside. Loops may cross themselves and each other.
double areaOf(const Outline& outline);

/// Returns whether a point is inside by the even-odd rule. Points exactly on the outline may count either
/// way.
bool isInside(const Outline& outline, const Vec2& p);

}  // namespace wend
