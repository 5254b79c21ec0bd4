#pragma once

#include <string>

#include "warp/image.h"

namespace wend {

/// Writes a WebP file without loss (OpenImageIO's is always lossy). 8 bits; grey becomes RGB. False, with the
/// reason, on failure.
bool writeWebp(const std::string& path, const Image& image, std::string& why);

/// Fills the pixels of a picture whose size and channels are known, colours not multiplied with alpha
/// (OpenImageIO multiplies and rounds them). False if the file is damaged or an animation.
bool readWebp(const std::string& path, Image& image);

}  // namespace wend
