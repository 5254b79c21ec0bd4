#pragma once

#include "bench/recorder.h"

namespace wend {

/// Adds rows of the dense kernels of the factor on fronts of the sizes that the bodies have, for every SIMD
/// target of this machine, beside the same work by the BLAS and LAPACK that CHOLMOD is linked with. Restores
/// the current target afterwards.
void addKernelRows(BenchRecorder& recorder);

}  // namespace wend
