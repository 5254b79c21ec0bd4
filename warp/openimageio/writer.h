#pragma once

#include <OpenImageIO/imageio.h>

#include "warp/picture_library.h"

namespace wend {

/// Returns the description of a picture for that format: size, depth, and the metadata of its source that the
/// format supports.
OIIO::ImageSpec fileSpec(PictureFormat format, const Image& image);

/// See PictureLibrary::write.
void writeStored(const PictureToWrite& writing);

}  // namespace wend
