#include "core/solver/refactor_policy.h"

#include <cmath>

namespace wend {
namespace {

// Rates of a nominal core. The factorization's grows with its size (small fronts are overhead): its time is
// modelled as flops / kFlopRate + entries · kEntryTime.
constexpr double kFlopRate = 55e9;
constexpr double kEntryTime = 4e-9;
constexpr double kSolveTime = 0.5e-9;  // per entry of the factor, for the pair of triangular solves
constexpr double kBlockTime = 2e-9;    // per d × d contribution to the matrix, d = 2
constexpr double kCellTime = 8e-9;     // of a product with the matrix, d = 2

}  // namespace

double SolverCost::factor() const {
    const double blocks = contributions * kBlockTime * std::pow(dimension / 2.0, 2);
    return factorFlops / kFlopRate + factorEntries * kEntryTime + blocks;
}

double SolverCost::iteration() const {
    return factorEntries * kSolveTime + cells * kCellTime * std::pow(dimension / 2.0, 2);
}

}  // namespace wend
