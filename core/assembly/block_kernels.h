#pragma once

#include "core/assembly/block_source.h"

namespace wend::isotropic {

/// Blocks [begin, end) of A, column-major, each the sum of its contributions in their order:
///   Σ a ((g·h) I + h gᵀ) + b g hᵀ,   g, h the gradients at `left` and `right`, (a, b) the pair of
///   coefficients of the term.
/// `gradients` has 2 doubles per corner in the plane; in space 4, the last one 0.
void blocks2(const int* start, const Contribution* contributions, const double* gradients,
             const double* coefficients, int begin, int end, double* values);
void blocks3(const int* start, const Contribution* contributions, const double* gradients,
             const double* coefficients, int begin, int end, double* values);

}  // namespace wend::isotropic
