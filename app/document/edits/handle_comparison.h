#pragma once

#include <vector>

#include "core/motion/handle.h"

namespace wend {

/// True if both take hold of the same points.
template <int Dim>
bool samePlace(const Handle<Dim>& a, const Handle<Dim>& b);

/// By which factor the times of `b` are those of `a`, judged by the motion that comes first; 1 if nothing
/// tells. The shape depends on the path, not on the speed: where all else is the same, so are the poses.
template <int Dim>
double timeScale(const std::vector<Handle<Dim>>& a, const std::vector<Handle<Dim>>& b);

/// The first time, by the clock of `b`, from which two lists of handles prescribe something different, where
/// the times of `a` are multiplied by the scale; infinity if never. −infinity if the rest shape's constraints
/// themselves differ.
template <int Dim>
double firstDifference(const std::vector<Handle<Dim>>& a, const std::vector<Handle<Dim>>& b,
                       double scale = 1);

/// True if both are one time, but for the rounding of a change of the clock.
bool sameTime(double a, double b);

}  // namespace wend
