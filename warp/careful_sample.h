#pragma once

#include "warp/sampling.h"
#include "warp/span_task.h"

namespace wend {

/// Samples a picture of half or float numbers where the plain filter may have made what is not in the
/// picture: beside numbers that are not finite, along edges of alpha, and where a negative lobe went below
/// zero or beyond the type's range. `(i, j)` is the pixel at or before the position, `(s, t)` ∈ [0, 1)² how
/// far beyond its centre that is; `colour` receives the channels in the level's own form (associated or not).
///
/// With the filter's weights w_k over the pixels whose numbers are all finite, normalized to Σ w_k = 1, and
/// C_k the associated colours, α_k the alphas (1 without alpha):
///
///     α = clamp(Σ w_k α_k, min α_k, max α_k)
///     P = Σ w_k C_k over α_k > 0, between α min(C_k / α_k) and α max(C_k / α_k), and within the range of C_k
///     E = Σ w_k C_k over α_k ≤ 0, within the range of C_k: light without coverage
///
/// and the colour is P + E. Where all numbers are finite and all alphas 1 (or all 0), the colour is bounded
/// only by min(0, min C_k) from below, and by the largest C_k if it would not fit into the type. If the pixel
/// that contains the position has a number that is not finite, its numbers are returned as they are, and no
/// other position sees them.
template <typename T>
void sampleCarefully(const SpanTask& task, Filter filter, int channels, int i, int j, float s, float t,
                     float* colour);

}  // namespace wend
