#pragma once

#include "core/motion/handle.h"

namespace wend {

/// Returns the fraction of the path u = e(s) at the fraction s of the motion's duration, with e(0) = 0 and
/// e(1) = 1:
///   linear s · in s² · out s (2 − s) · inOut s² (3 − 2s).
/// `in` starts and `out` ends with zero speed, `inOut` both. s is to be in [0, 1]; it is not clamped. All
/// kinds increase there.
double ease(Ease kind, double s);
/// Returns e′(s).
double easeRate(Ease kind, double s);
/// Returns s with e(s) = u, for u in [0, 1]: u, √u, 1 − √(1 − u), and for inOut ½ − sin(⅓ arcsin(1 − 2u)).
double easeInverse(Ease kind, double u);

}  // namespace wend
