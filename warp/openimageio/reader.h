#pragma once

#include "warp/picture_library.h"

namespace wend {

/// See PictureLibrary.
StoredPicture readStoredHeader(const PictureSource& source);
StoredPicture readStored(const PictureSource& source, double maxMegapixels, PixelSink& sink);

}  // namespace wend
