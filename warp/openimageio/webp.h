#pragma once

#include <OpenImageIO/imageio.h>

#include <string>

#include "warp/image.h"

namespace wend {

/// Writes 8-bit RGB or RGBA (colours not associated) without loss, with the profile of `spec` and, as EXIF
/// and XMP, what it says about the picture. Returns what went wrong, empty on success.
std::string writeWebp(const std::string& path, const Image& image, const OIIO::ImageSpec& spec);

/// Reads into an image whose size and channels are set; the colours are then unassociated. False for what is
/// no single picture (an animation) or damaged: nothing is changed then.
bool readWebp(const std::string& path, Image& image);

/// Adds the file's colour profile, EXIF and XMP to `spec`.
void readWebpMetadata(const std::string& path, OIIO::ImageSpec& spec);

}  // namespace wend
