#include "core/solver/refactor_policy.h"

#include <cmath>

namespace wend {
namespace {

// Rates of a nominal core. A factorization is modelled as flops / kFlopRate + entries · kEntryTime: the
// second is the work around small fronts.
constexpr double kFlopRate = 170e9;
constexpr double kEntryTime = 1.2e-9;
constexpr double kSolveTime = 0.2e-9;  // per entry of the factor, for the pair of triangular solves
constexpr double kBlockTime = 2e-9;    // per contribution to the matrix
constexpr double kCellTime = 12e-9;    // of a product with the matrix, d = 2

}  // namespace

double SolverCost::factor() const {
    return factorFlops / kFlopRate + factorEntries * kEntryTime + contributions * kBlockTime;
}

double SolverCost::iteration() const {
    return factorEntries * kSolveTime + cells * kCellTime * std::pow(dimension / 2.0, 2);
}

}  // namespace wend
