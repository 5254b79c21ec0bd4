#pragma once

#include <string>

#include "warp/image.h"

namespace wend {

/// Returns whether the format of `path`, by its extension, holds pixels of that type. False for a format that
/// neither writeImage() nor writePhotoshopFile() writes.
bool holdsType(const std::string& path, PixelType type);

/// Returns whether the format of `path` rounds or clamps pixels of that type, in pictures and in layers.
bool roundsNumbers(const std::string& path, PixelType type);

/// Returns whether the picture has negative light, which the format makes 0 (Radiance HDR).
bool losesNegativeLight(const std::string& path, const Image& image);

/// Returns whether it holds transparency; without it a picture is composed over white.
bool holdsAlpha(const std::string& path);

/// Returns whether the picture's colours have a profile that the format cannot hold.
bool losesProfile(const std::string& path, const Image& image);

/// writeImage() of image.h; of WebP `lossy` drops what the eye hardly misses, for a file of a fraction of the
/// size.
void writeImage(const std::string& path, const Image& header, int stripRows, const MakeRows& makeRows,
                bool lossy);

}  // namespace wend
