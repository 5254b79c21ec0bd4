#pragma once

#include <vector>

#include "core/motion/handle.h"

namespace wend {

/// Returns whether both hold the same points.
template <int Dim>
bool samePlace(const Handle<Dim>& a, const Handle<Dim>& b);

/// Returns the factor from the times of `a` to those of `b`, judged by the first motion; 1 if there is none.
/// The shape depends on the path and not on the speed, so poses stay valid if all else is equal.
template <int Dim>
double timeScale(const std::vector<Handle<Dim>>& a, const std::vector<Handle<Dim>>& b);

/// Returns the first time, on the clock of `b`, from which two lists of handles prescribe different
/// constraints if the times of `a` are multiplied by the scale; infinity if never, −infinity if the
/// constraints of the rest shape differ.
template <int Dim>
double firstDifference(const std::vector<Handle<Dim>>& a, const std::vector<Handle<Dim>>& b,
                       double scale = 1);

/// Returns the time from which on two lists of handles, with the same clock, prescribe the same places again:
/// the end of the last motion in which they differ. −infinity if they never differ, infinity if they do to
/// the end.
template <int Dim>
double lastDifference(const std::vector<Handle<Dim>>& a, const std::vector<Handle<Dim>>& b);

/// Returns whether two times are equal up to the rounding of a change of the clock.
bool sameTime(double a, double b);

}  // namespace wend
