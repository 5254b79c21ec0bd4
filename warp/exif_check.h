#pragma once

#include <cstddef>
#include <string>

namespace wend {

enum class ExifState { Fits, Mended, Useless };

/// Sanitizes EXIF data in a picture: a TIFF in `bytes`, of `size` bytes from `from` on, which must all exist.
/// An invalid entry (a value or directory that is outside or occurs twice, of unknown type, or of more than
/// 64 KB) is replaced by one that no reader uses, so that the others, such as the orientation, remain valid.
/// Useless: without a header or a first directory. Necessary because OpenImageIO trusts counts and offsets:
/// it reads out of bounds, and values of millions end the program.
ExifState mendExif(std::string& bytes, std::size_t from, std::size_t size);

}  // namespace wend
