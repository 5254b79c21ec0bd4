#pragma once

#include <OpenImageIO/imageio.h>

#include "warp/picture_library.h"

namespace wend {

/// What a file of that format says of a picture: size, depth, and what its source brought along, as far as
/// the format has a place for it.
OIIO::ImageSpec fileSpec(PictureFormat format, const Image& image);

/// As PictureLibrary::write says.
void writeStored(const PictureToWrite& writing);

}  // namespace wend
