#pragma once

#include <string>

#include "warp/image.h"

namespace wend {

/// Whether the format of `path`, by its extension, holds pixels of that type. False for a format that
/// canWriteImage() does not know.
bool holdsType(const std::string& path, PixelType type);

/// Whether it holds transparency; without it a picture is laid over white.
bool holdsAlpha(const std::string& path);

/// Whether the picture's colours have a profile that the format has no place for.
bool losesProfile(const std::string& path, const Image& image);

/// writeImage() of image.h; of WebP `lossy` drops what the eye hardly misses, for a file of a fraction of the
/// size.
void writeImage(const std::string& path, const Image& header, int stripRows, const MakeRows& makeRows,
                bool lossy);

}  // namespace wend
