#pragma once

#include "bench/body.h"
#include "bench/recorder.h"

namespace wend {

/// Adds the parts of one evaluation of the velocity field, and the whole: with a factorization as in the
/// paper, with the solver's own factor of this shape, and with the factor of an earlier one. Returns the
/// least possible time of a solve, in seconds, in which memory delivers a factor in single precision twice.
template <int Dim>
double addSolverRows(const Body<Dim>& body, BenchRecorder& recorder);

}  // namespace wend
