#pragma once

namespace wend {

/// Returns the growth of the step by proportional-integral control for an embedded method with an error
/// estimate of order h⁵ (Gustafsson; Hairer, Wanner II, IV.2): h′ = h · 0.9 e_n^{−0.7/5} e_{n−1}^{0.4/5},
/// where e is the error relative to the tolerance, limited to [h/5, 5h]. `last` is the error of the previous
/// step, 0 for none. Errors below 1e-4 count as that, so that one lucky step does not make the next one long.
double growthAfterStep(double error, double last);

/// Returns the factor of the step for another attempt after an error > 1: 0.9 error^(−1/5), limited to [0.2,
/// 0.9]; 0.2 for an error that is not finite.
double shrinkAfterError(double error);

}  // namespace wend
