#pragma once

#include <string>

#include "core/base/input_file.h"
#include "warp/picture_format.h"

namespace wend {

/// Returns the bytes of a JPEG or PNG with invalid EXIF (mendExif) and IPTC data hidden; empty if all is
/// valid, or for other formats: then the file itself is used. A photograph is not refused because of its
/// metadata.
std::string bytesWithSoundMetadata(const InputFile& file, PictureFormat format);

}  // namespace wend
