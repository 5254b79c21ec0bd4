#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/mesh/formats/scalar_type.h"

namespace wend::formats {

/// The layout of the binary data arrays of a .vtu file, [header][bytes]. The header is a number of the given
/// type with the length or, if compressed, the number of blocks, their length, that of the last one and their
/// compressed lengths.
struct VtuEncoding {
    std::endian order = std::endian::little;
    Scalar header = Scalar::UInt32;
    enum class Compressor { None, Zlib, Lz4, Lzma } compressor = Compressor::None;
    bool base64 = true;  // else raw; header and compressed blocks are encoded one by one
};

/// Return the type of a name in .vtu files (nothing if it is unknown), and the name of a type.
std::optional<Scalar> vtuScalarNamed(std::string_view name);
std::string_view vtuScalarName(Scalar type);

/// Returns how many bytes an array claims to have, checked against what `text` can hold. Nothing is
/// decompressed.
std::size_t vtuArraySize(std::string_view text, const VtuEncoding& encoding);

/// Returns the bytes of one array. `text` begins with it and may continue. Throws InputError for anything
/// damaged, and never allocates more than the data can be.
std::string decodeVtuArray(std::string_view text, const VtuEncoding& encoding);
/// Returns the text of an array with these bytes.
std::string encodeVtuArray(std::string_view bytes, const VtuEncoding& encoding);

}  // namespace wend::formats
