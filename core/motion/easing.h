#pragma once

#include "core/motion/handle.h"

namespace wend {

/// How far along its path a motion is, u = e(s), at the fraction s of its window; e(0) = 0 and e(1) = 1:
///   linear s · in s² · out s (2 − s) · inOut s² (3 − 2s).
/// `in` starts and `out` ends at rest, `inOut` does both.
double ease(Ease kind, double s);
/// e′(s).
double easeRate(Ease kind, double s);
/// s with e(s) = u, for u in [0, 1].
double easeInverse(Ease kind, double u);

}  // namespace wend
