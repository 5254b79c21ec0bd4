#include "core/solver/refactor_policy.h"

#include <cmath>

namespace wend {
namespace {

// Rates of a nominal core. A factorization is modelled as flops / kFlopRate + entries · kEntryTime: the
// second is the work around small fronts. What a factor costs is half as much again as was measured beside
// the solves, since ten RK4 steps take 2 to 18 % less time so (docs/benchmarks.md).
constexpr double kFlopRate = 113e9;
constexpr double kEntryTime = 1.8e-9;
constexpr double kSolveTime = 0.2e-9;  // per entry of the factor, for the pair of triangular solves
constexpr double kBlockTime = 3e-9;    // per contribution to the matrix
constexpr double kCellTime = 12e-9;    // of a product with the matrix, d = 2

}  // namespace

/// Returns the seconds of a nominal core for an assembly and a factorization.
double SolverCost::factor() const {
    return factorFlops / kFlopRate + factorEntries * kEntryTime + contributions * kBlockTime;
}

/// Returns the seconds of a nominal core for an iteration. The work on a cell grows with the square of the
/// dimension.
double SolverCost::iteration() const {
    return factorEntries * kSolveTime + cells * kCellTime * std::pow(dimension / 2.0, 2);
}

}  // namespace wend
