#pragma once

#include "bench/body.h"
#include "bench/recorder.h"

namespace wend {

/// Adds a frame of a live drag of the right end along a curve with a hand's jitter: the flow alone, and with
/// the distortion of every cell and, in 2D, the picture at the size of a window.
template <int Dim>
void addDragRows(const Body<Dim>& body, BenchRecorder& recorder);

}  // namespace wend
