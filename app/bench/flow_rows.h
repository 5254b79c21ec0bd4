#pragma once

#include "app/bench/body.h"
#include "app/bench/recorder.h"

namespace wend {

/// The whole flow: ten steps of the classical Runge–Kutta method beside the paper's scheme, each integrator
/// to a true error of 1e-4 of the diagonal. `bound`: the least time of a solve, from addSolverRows().
template <int Dim>
void addFlowRows(const Body<Dim>& body, double bound, BenchRecorder& recorder);

/// What the paper's table of times has: ten steps by its scheme and what they are made of, and ours.
template <int Dim>
void addPaperFlow(const Body<Dim>& body, BenchRecorder& recorder);

}  // namespace wend
