#pragma once

#include "core/meshing/outline.h"
#include "warp/image.h"

namespace wend {

/// The outline of the pixels of a picture that are connected with a place and whose colours differ from the
/// one there by no more than the tolerance (of full scale, in the channel that differs most; colours count as
/// far as they are opaque), by marching squares at sub-pixel accuracy. Empty beside the picture.
Outline outlineOfColour(const Image& image, const Vec<2>& place, double tolerance);

}  // namespace wend
