#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/mesh/formats/scalar_type.h"

namespace wend::formats {

/// How the binary data arrays of a .vtu are laid out: [header][bytes], the header a number of the given type
/// with the length, or, compressed, the number of blocks, their length, that of the last one and their
/// compressed lengths.
struct VtuEncoding {
    std::endian order = std::endian::little;
    Scalar header = Scalar::UInt32;
    enum class Compressor { None, Zlib, Lz4, Lzma } compressor = Compressor::None;
    bool base64 = true;  // else raw; header and compressed blocks are encoded one by one
};

std::optional<Scalar> vtuScalarNamed(std::string_view name);
std::string_view vtuScalarName(Scalar type);

/// How many bytes an array says that it has, checked against what `text` can hold. Nothing is expanded.
std::size_t vtuArraySize(std::string_view text, const VtuEncoding& encoding);

/// The bytes of one array. `text` begins with it and may go on. Throws InputError for anything damaged,
/// without ever allocating what the data cannot be.
std::string decodeVtuArray(std::string_view text, const VtuEncoding& encoding);
std::string encodeVtuArray(std::string_view bytes, const VtuEncoding& encoding);

}  // namespace wend::formats
