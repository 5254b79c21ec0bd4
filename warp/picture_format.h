#pragma once

#include <string>
#include <vector>

#include "core/mesh/input_file.h"

namespace wend {

/// The formats whose readers are entered, each tried with damaged files (docs/reliability.md), and last one
/// that is only written.
enum class PictureFormat { Png, Jpeg, Tiff, Exr, Webp, Hdr, Bmp, Tga, Pnm, Jpeg2000 };

/// Which of them a file is of: by its first bytes, never by its name, and never by trying one reader after
/// the other. TGA has no mark; there the whole header has to make sense. Throws InputError(path, reason) that
/// says what the file is instead, where that can be told.
PictureFormat pictureFormat(const InputFile& file);

/// The extensions that such files usually have, lower case, with the dot.
const std::vector<std::string>& pictureFileExtensions();

}  // namespace wend
