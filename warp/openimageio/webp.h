#pragma once

#include <OpenImageIO/imageio.h>
#include <webp/encode.h>

#include <cstdint>
#include <string>
#include <vector>

#include "warp/image.h"

namespace wend {

/// Configures the encoder; false if the library's version differs.
bool prepareWebp(WebPConfig& config, bool lossy);

/// Imports the pixels of an image for the encoder; initializes `picture`, which the caller frees.
bool importWebp(WebPPicture& picture, const Image& image);

/// Returns a file of a picture or a film with the profile of `spec` and its metadata as EXIF and XMP.
std::vector<std::uint8_t> withMetadata(std::vector<std::uint8_t> file, const OIIO::ImageSpec& spec);

/// Writes 8-bit RGB or RGBA (unassociated), lossless unless `lossy`, with that metadata. Returns the error,
/// or an empty string.
std::string writeWebp(const std::string& path, const Image& image, const OIIO::ImageSpec& spec,
                      bool lossy = false);

/// Reads into an image with given size and channels; colours are then unassociated. Returns false without
/// changes for animations and damaged files.
bool readWebp(const std::string& path, Image& image);

/// Returns the number of pictures in an animation; 1 for other files.
int webpFrames(const std::string& path);

/// Adds the file's colour profile, EXIF and XMP to `spec`.
void readWebpMetadata(const std::string& path, OIIO::ImageSpec& spec);

}  // namespace wend
