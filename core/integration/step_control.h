#pragma once

namespace wend {

/// Proportional-integral control of the step of an embedded method whose error estimate is of order h⁵
/// (Gustafsson; Hairer, Wanner II, IV.2): h′ = h · 0.9 e_n^{−0.7/5} e_{n−1}^{0.4/5}, e the error over the
/// tolerance, kept in [h/5, 5h]. `last` is the error of the step before, 0 if there is none.
double growthAfterStep(double error, double last);

/// The factor for trying again after an error > 1.
double shrinkAfterError(double error);

}  // namespace wend
