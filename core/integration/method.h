#pragma once

namespace wend {

/// Adaptive embedded order 5(4), classical order 4, and order 2.
enum class Method { DormandPrince, RungeKutta4, Midpoint };

}  // namespace wend
