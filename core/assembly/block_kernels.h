#pragma once

#include "core/assembly/block_source.h"

namespace wend::isotropic {

/// Compute the blocks [begin, end) of A, column-major, each as the sum of its contributions in their order:
///   Σ a ((g·h) I + h gᵀ) + b g hᵀ
/// with g and h the gradients at `left` and `right`, and (a, b) the pair of coefficients of the term.
/// `gradients` has 2 doubles per corner in 2D, and 4 in 3D, of which the last is 0.
void blocks2(const int* start, const Contribution* contributions, const double* gradients,
             const double* coefficients, int begin, int end, double* values);
void blocks3(const int* start, const Contribution* contributions, const double* gradients,
             const double* coefficients, int begin, int end, double* values);

}  // namespace wend::isotropic
