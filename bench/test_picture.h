#pragma once

#include "warp/image.h"

namespace wend {

/// A picture of four channels with waves of all lengths, so that no filter has it easy: the same in any type.
Image testPicture(int width, int height, PixelType type = PixelType::UInt8);

}  // namespace wend
