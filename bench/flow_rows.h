#pragma once

#include "bench/body.h"
#include "bench/recorder.h"

namespace wend {

/// Adds the whole flow: ten steps of the classical Runge–Kutta method beside the paper's scheme, each
/// integrator to a true error of 1e-4 of the diagonal. `bound` is the least time of a solve, from
/// addSolverRows().
template <int Dim>
void addFlowRows(const Body<Dim>& body, double bound, BenchRecorder& recorder);

/// Adds the rows of the paper's table of times: ten steps by its scheme and their parts, and Wend's own.
template <int Dim>
void addPaperFlow(const Body<Dim>& body, BenchRecorder& recorder);

}  // namespace wend
