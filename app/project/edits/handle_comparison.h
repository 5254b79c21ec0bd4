#pragma once

#include <vector>

#include "app/project/pin.h"

namespace wend {

/// Returns whether both hold the same points.
bool samePlace(const Pin& a, const Pin& b);

/// Returns the factor from the times of `a` to those of `b`, judged by the first motion; 1 if there is none.
/// The shape depends on the path and not on the speed, so poses stay valid if all else is equal.
double timeScale(const std::vector<Pin>& a, const std::vector<Pin>& b);

/// Returns the first time, on the clock of `b`, from which two lists of handles prescribe different
/// constraints if the times of `a` are multiplied by the scale; infinity if never, −infinity if the
/// constraints of the rest shape differ.
double firstDifference(const std::vector<Pin>& a, const std::vector<Pin>& b, double scale = 1);

/// Returns the time from which on two lists of handles, with the same clock, prescribe the same places again:
/// the end of the last motion in which they differ. −infinity if they never differ, infinity if they do to
/// the end.
double lastDifference(const std::vector<Pin>& a, const std::vector<Pin>& b);

/// Returns whether two times are equal up to the rounding of a change of the clock.
bool sameTime(double a, double b);

}  // namespace wend
