#pragma once

#include "app/bench/body.h"
#include "app/bench/recorder.h"

namespace wend {

/// The whole flow: ten steps of the classical Runge–Kutta method beside the paper's scheme, each integrator
/// to a true error of 1e-4 of the diagonal, and the frame of a live drag.
template <int Dim>
void addFlowRows(const Body<Dim>& body, BenchRecorder& recorder);

}  // namespace wend
