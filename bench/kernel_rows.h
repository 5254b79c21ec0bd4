#pragma once

#include "bench/recorder.h"

namespace wend {

/// Measures the dense kernels of the factor on fronts of the sizes that the bodies have, for every SIMD
/// target of this machine, beside the same work by the BLAS and LAPACK that CHOLMOD is linked with. The
/// target in use is afterwards what it was before.
void addKernelRows(BenchRecorder& recorder);

}  // namespace wend
