#pragma once

#include "warp/image.h"

namespace wend {

/// Returns a picture of four channels with waves of all lengths, which is hard for every filter, and the same
/// in every type.
Image testPicture(int width, int height, PixelType type = PixelType::UInt8);

}  // namespace wend
