#pragma once

#include "warp/image.h"

namespace wend {

/// Returns the picture rotated and mirrored according to an EXIF orientation tag (1 to 8; other values mean
/// upright).
Image upright(Image image, int orientation);

}  // namespace wend
