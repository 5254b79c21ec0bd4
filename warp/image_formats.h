#pragma once

#include <string>

#include "warp/image.h"

namespace wend {

/// Whether the format of `path`, by its extension, holds pixels of that type. False for a format that
/// canWriteImage() does not know.
bool holdsType(const std::string& path, PixelType type);

/// Whether it holds transparency; without it a picture is laid over white.
bool holdsAlpha(const std::string& path);

}  // namespace wend
