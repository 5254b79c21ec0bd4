#pragma once

#include "warp/picture_library.h"

namespace wend {

/// As PictureLibrary::write says.
void writeStored(const PictureToWrite& writing);

}  // namespace wend
