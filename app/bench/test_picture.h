#pragma once

#include "warp/image.h"

namespace wend {

/// A picture of 8 bit and four channels with waves of all lengths, so that no filter has it easy.
Image testPicture(int width, int height);

}  // namespace wend
