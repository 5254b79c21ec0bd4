#pragma once

#include "warp/image.h"

namespace wend {

/// The picture that an EXIF orientation tag (1 to 8, anything else means upright) asks to show: turned and
/// mirrored so that it stands upright.
Image upright(Image image, int orientation);

}  // namespace wend
