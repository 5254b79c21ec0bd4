#include "core/integration/step_control.h"

#include <algorithm>
#include <cmath>

namespace wend {

namespace {

constexpr double kSafety = 0.9, kLeastFactor = 0.2, kMostFactor = 5;
// smallest error used by the control: one lucky step must not affect the next
constexpr double kExactly = 1e-4;

}  // namespace

double growthAfterStep(double e, double last) {
    e = std::max(e, kExactly);
    last = last > 0 ? std::max(last, kExactly) : e;
    return std::clamp(kSafety * std::pow(e, -0.7 / 5) * std::pow(last, 0.4 / 5), kLeastFactor, kMostFactor);
}

double shrinkAfterError(double e) {
    return std::isfinite(e) ? std::clamp(kSafety * std::pow(e, -1.0 / 5), kLeastFactor, kSafety)
                            : kLeastFactor;
}

}  // namespace wend
