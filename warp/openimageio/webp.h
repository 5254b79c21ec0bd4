#pragma once

#include <OpenImageIO/imageio.h>
#include <webp/encode.h>

#include <cstdint>
#include <string>
#include <vector>

#include "warp/image.h"

namespace wend {

/// How the encoder is to work; false if the library is of another version.
bool prepareWebp(WebPConfig& config, bool lossy);

/// The pixels of an image, for the encoder; `picture` is initialized here, and freed by the caller.
bool importWebp(WebPPicture& picture, const Image& image);

/// A file, of one picture or a film, with the profile of `spec` and, as EXIF and XMP, what it says about the
/// picture.
std::vector<std::uint8_t> withMetadata(std::vector<std::uint8_t> file, const OIIO::ImageSpec& spec);

/// Writes 8-bit RGB or RGBA (colours not associated), without loss unless `lossy`, with that metadata.
/// Returns what went wrong, empty on success.
std::string writeWebp(const std::string& path, const Image& image, const OIIO::ImageSpec& spec,
                      bool lossy = false);

/// Reads into an image whose size and channels are set; the colours are then unassociated. False for what is
/// no single picture (an animation) or damaged: nothing is changed then.
bool readWebp(const std::string& path, Image& image);

/// How many pictures an animation has; 1 of others.
int webpFrames(const std::string& path);

/// Adds the file's colour profile, EXIF and XMP to `spec`.
void readWebpMetadata(const std::string& path, OIIO::ImageSpec& spec);

}  // namespace wend
