#pragma once

#include "bench/recorder.h"

namespace wend {

/// Megapixels per second of the texture warp, by filter and depth: a picture of 24 megapixels on 5 000
/// vertices, turned and bent; and of a copy of the picture, which is the least that it could take.
void addWarpRows(BenchRecorder& recorder);

}  // namespace wend
