#pragma once

#include <string>

#include "core/mesh/input_file.h"
#include "warp/picture_format.h"

namespace wend {

/// The bytes of a JPEG or PNG with what does not keep to its place in its EXIF (mendExif) and IPTC hidden;
/// empty if all keeps to it, or in other formats: then the file is good as it is. A photograph is not refused
/// for what an odd program has written beside its pixels.
std::string bytesWithSoundMetadata(const InputFile& file, PictureFormat format);

}  // namespace wend
