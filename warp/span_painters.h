#pragma once

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define WEND_WIDE_SPANS
#include <immintrin.h>
#endif

#include <cstring>
#include <type_traits>

#include "warp/careful_sample.h"
#include "warp/pixels.h"
#include "warp/span_task.h"

// The hot loops are compiled twice: for every machine, and for those with vectors of eight floats (AVX2, FMA
// and F16C: since 2013). Nothing of the standard library or of Eigen is used in there: an inline function
// compiled for newer machines only might be linked for all.

namespace wend {

inline constexpr int kFarthestReach = 32;  // of an ellipse, in pixels of its level

namespace portable {
#define WEND_TARGET
#include "warp/span_filters.inl"
#undef WEND_TARGET
}  // namespace portable

#if defined(WEND_WIDE_SPANS)
#pragma GCC push_options
#pragma GCC target("avx2,fma,f16c")
namespace wide {
#define WEND_WIDE
#define WEND_TARGET __attribute__((target("avx2,fma,f16c")))  // templates do not take it from the pragma
#include "warp/span_filters.inl"
#undef WEND_TARGET
#undef WEND_WIDE
}  // namespace wide
#pragma GCC pop_options
#endif

/// The best for the machine at hand, or what runs everywhere.
template <typename T>
SpanFunctions spanFunctionsOf(int channels, Filter filter, bool wideVectors) {
#if defined(WEND_WIDE_SPANS)
    if (wideVectors && __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") &&
        __builtin_cpu_supports("f16c"))
        return wide::spanFunctions<T>(channels, filter);
#endif
    static_cast<void>(wideVectors);
    return portable::spanFunctions<T>(channels, filter);
}

}  // namespace wend
