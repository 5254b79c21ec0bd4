#pragma once

#include "warp/alpha_outline_options.h"
#include "warp/image.h"

namespace wend {

/// Returns whether the upper and lower edges are opaque.
bool hasOpaqueEdges(const Image& picture);
/// Returns whether the outline cuts off a wide soft edge, a glow or a shadow.
bool cutsSoftEdges(const Image& picture, const AlphaOutlineOptions& outline);
/// Returns whether most of what the outline encloses is empty: thin strokes around areas without fill.
bool isLineArt(const Image& picture, const AlphaOutlineOptions& outline);

}  // namespace wend
