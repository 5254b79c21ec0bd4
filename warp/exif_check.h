#pragma once

#include <cstddef>
#include <string>

namespace wend {

enum class ExifState { Fits, Mended, Useless };

/// Looks at what stands as EXIF in a picture: a TIFF in `bytes`, of `size` bytes from `from` on, all of which
/// are there. An entry that does not keep to it (a value or directory that begins or ends outside or comes
/// twice, of no known type, of more than 64 KB) is made one that nobody reads, so that the others, the
/// orientation among them, still count. Useless: without a header or a first directory. Why: OpenImageIO
/// takes counts and places as they are; what lies outside it reads, and values of millions end the program.
ExifState mendExif(std::string& bytes, std::size_t from, std::size_t size);

}  // namespace wend
