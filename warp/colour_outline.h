#pragma once

#include "core/meshing/outline.h"
#include "warp/image.h"

namespace wend {

/// Returns the outline of the pixels that are connected with a place and differ from its colour by at most
/// the tolerance (of full scale, in the channel that differs most; weighted with opacity), by marching
/// squares with sub-pixel accuracy. Empty outside the picture.
Outline outlineOfColour(const Image& image, const Vec2& place, double tolerance);

}  // namespace wend
