#pragma once

#include <stop_token>
#include <vector>

#include "warp/image.h"

namespace wend {

/// Returns whether the program that inpaint() runs is installed: G'MIC, command `gmic`.
bool canInpaint();

/// Returns the part of a picture that a hole in that box is filled from.
PixelBox surroundings(const PixelBox& hole, int width, int height);

/// Fills the pixels where `hole` (a row after the other) is set with what surrounds them, by matching patches
/// over several scales; the others keep their values. The picture has floats, and associated colours where it
/// has alpha, which is filled, too. The same input gives the same result. Holes that are larger than a
/// megapixel with their surroundings are filled at a lower resolution. Throws InputError("gmic", reason) if
/// the program fails, and Cancelled.
Image inpainted(const Image& picture, const std::vector<bool>& hole, const std::stop_token& stop = {});

}  // namespace wend
