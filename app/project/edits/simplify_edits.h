#pragma once

#include <vector>

#include "app/project/edits/timing_edits.h"

namespace wend {

/// Both leave motions that do not only translate as they are.

/// Makes motions straight: their ends, times and easing stay.
Design straightened(const Design& design, const std::vector<MotionId>& motions);

/// Replaces motions by as few straight ones between key poses as needed: at every time the handle is within
/// `tolerance` of where it was. Each of them has the easing that fits best.
Design withFewKeys(const Design& design, std::vector<MotionId> motions, double tolerance);

}  // namespace wend
