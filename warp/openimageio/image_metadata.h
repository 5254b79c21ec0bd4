#pragma once

#include <OpenImageIO/imageio.h>

#include <string>

namespace wend {

/// Packs OpenImageIO's description of a picture apart from its pixels, for PictureMetadata: its windows and
/// attributes.
std::string packed(const OIIO::ImageSpec& spec);

/// Returns that description; one without attributes for anything else than packed bytes.
OIIO::ImageSpec unpacked(const std::string& bytes);

}  // namespace wend
