#pragma once

#include "core/meshing/outline.h"

namespace wend {

enum class OutlineOperation { Add, TakeAway, Keep };  // what is in one or the other, in one only, in both

/// What two outlines make together, each of them by even and odd; they may touch and cross themselves and
/// each other in any way (CGAL, exact intersections). Corners that come anew lie on a grid of 2⁻¹² units;
/// parts and holes of less area than `smallest` are dropped. The loops of the result do not cross, outer ones
/// are counter-clockwise in (x, y), holes clockwise. It may be empty. Throws InputError for what is not
/// finite.
Outline combined(const Outline& base, const Outline& piece, OutlineOperation operation, double smallest = 0);

/// Of the even–odd inside.
double areaOf(const Outline& outline);

/// Whether a place is inside, by even and odd.
bool isInside(const Outline& outline, const Vec<2>& p);

}  // namespace wend
