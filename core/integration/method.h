#pragma once

namespace wend {

/// The methods of integration: adaptive embedded order 5(4), classical order 4, order 2, and adaptive
/// Adams–Bashforth–Moulton of variable order.
enum class Method { DormandPrince, RungeKutta4, Midpoint, Adams };

/// Returns whether the method controls its steps by the error.
constexpr bool isAdaptive(Method method) {
    return method == Method::DormandPrince || method == Method::Adams;
}

}  // namespace wend
