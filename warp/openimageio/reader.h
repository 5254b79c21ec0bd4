#pragma once

#include "warp/picture_library.h"

namespace wend {

/// As PictureLibrary says.
StoredPicture readStoredHeader(const std::string& path, PictureFormat format);
StoredPicture readStored(const std::string& path, PictureFormat format, double maxMegapixels, void (*goOn)());

}  // namespace wend
