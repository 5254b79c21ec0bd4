#pragma once

#include <vector>

#include "core/motion/handle.h"

namespace wend {

/// Returns the share of a handle's motions that is done at time t, in [0, 1]:
///   r(t) = D(t) / D(∞),  D(t) = Σ_i T_i (e_i(s_i(b)) − e_i(s_i(a))),
/// with the duration T_i and the easing e_i of motion i, s_i the fraction of its interval, and [a, b] what
/// the handle's active range and t leave of that interval. A handle that never moves has 1.
template <int Dim>
double reachOf(const Handle<Dim>& handle, double t);

/// Returns the time at which the last motion ends, or `none` if there is none. Active ranges do not count.
template <int Dim>
double lastMotionEnd(const std::vector<Handle<Dim>>& handles, double none);

}  // namespace wend
