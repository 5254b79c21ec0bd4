#pragma once

#include "app/bench/recorder.h"

namespace wend {

/// Megapixels per second of the texture warp, by filter: a picture of 24 megapixels on 5 000 vertices, turned
/// and bent.
void addWarpRows(BenchRecorder& recorder);

}  // namespace wend
