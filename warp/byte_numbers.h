#pragma once

#include <cstdint>
#include <string_view>

namespace wend {

/// Returns a number of a file's header, of up to four bytes that are there: most significant byte first, or
/// last.
inline std::uint32_t bigEndian(std::string_view bytes, std::size_t at = 0, std::size_t size = 4) {
    std::uint32_t value = 0;
    for (const unsigned char byte : bytes.substr(at, size)) value = value << 8 | byte;
    return value;
}
inline std::uint32_t littleEndian(std::string_view bytes, std::size_t at, std::size_t size) {
    std::uint32_t value = 0;
    for (std::size_t k = size; k-- > 0;) value = value << 8 | static_cast<unsigned char>(bytes[at + k]);
    return value;
}

}  // namespace wend
