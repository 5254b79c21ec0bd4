#pragma once

#include <optional>
#include <span>
#include <string_view>

namespace wend {

/// The instruction sets that the vectorized kernels are compiled for, least first. Kernels are written with
/// Highway, which calls the variant of the target in use. Every target sums in one order of its own: results
/// repeat to the bit on one target, over threads and repeats, and agree between targets to rounding.
enum class SimdTarget { Sse2, Ssse3, Sse4, Avx2, Avx512 };

/// Returns the target's name as WEND_SIMD and the benchmark have it: "sse2" … "avx512".
std::string_view nameOf(SimdTarget target);
/// Returns the target of such a name; nothing for other names.
std::optional<SimdTarget> simdTargetNamed(std::string_view name);

/// Returns the targets that this processor has, least first; never empty.
std::span<const SimdTarget> supportedSimdTargets();

/// Returns the target in use: the processor's best one until another is set.
SimdTarget simdTarget();

/// Makes all kernels run on `target` from now on. No kernel may run in another thread meanwhile. Throws
/// std::invalid_argument if the processor lacks the target.
void setSimdTarget(SimdTarget target);

/// Sets the target that the environment variable WEND_SIMD names, if it is set. Throws std::invalid_argument
/// for an unknown name and for a target that the processor lacks.
void useSimdOfEnvironment();

}  // namespace wend
