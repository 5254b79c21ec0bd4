#include "warp/png_check.h"

#include <array>
#include <cstdint>
#include <cstring>
#include <fstream>

namespace wend {
namespace {

std::uint64_t bigEndian(const unsigned char* bytes) {
    std::uint64_t value = 0;
    for (int i = 0; i < 4; ++i) value = value << 8 | bytes[i];
    return value;
}

bool isPng(std::ifstream& file) {
    std::array<char, 8> signature{};
    file.read(signature.data(), 8);
    return file && std::memcmp(signature.data(), "\x89PNG\r\n\x1a\n", 8) == 0;
}

/// Bytes of the scanlines as they are packed, from the 13 of the header: width and height (4 each), bits per
/// sample, colour type. Each row has a byte for its filter before it. What decoders make of 1-bit and palette
/// files is 8 to 32 times as much.
double packedBytes(const std::array<unsigned char, 13>& header) {
    constexpr std::array<int, 7> channels{1, 0, 3, 1, 2, 0, 4};  // by colour type; others are refused later
    const std::uint64_t width = bigEndian(header.data()), height = bigEndian(header.data() + 4);
    const std::uint64_t bits = header[9] < channels.size() ? header[8] * channels[header[9]] : 0;
    const std::uint64_t row = 1 + (width * bits + 7) / 8;
    return static_cast<double>(height) * static_cast<double>(row);
}

}  // namespace

std::string pngProblem(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    if (!isPng(file)) return {};
    file.seekg(0, std::ios::end);
    const auto size = static_cast<std::uint64_t>(file.tellg());
    std::uint64_t position = 8, compressed = 0;
    double packed = 0;
    for (std::array<unsigned char, 8> head{}; position + 12 <= size;) {
        file.seekg(static_cast<std::streamoff>(position));
        file.read(reinterpret_cast<char*>(head.data()), 8);
        const std::string name(reinterpret_cast<char*>(head.data()) + 4, 4);
        const std::uint64_t length = bigEndian(head.data());
        if (name == "IHDR" && length == 13) {
            std::array<unsigned char, 13> header{};
            file.read(reinterpret_cast<char*>(header.data()), 13);
            packed = packedBytes(header);
        }
        position += 12 + length;
        if (name == "IDAT") compressed += length;
        if (position > size) return "is truncated in chunk " + name;
        // Deflate packs at most 1032 bytes into one.
        if (name == "IEND")
            return packed / 1032 > static_cast<double>(compressed) + 1 ? "claims more pixels than it can hold"
                                                                       : "";
    }
    return "is truncated: its end is missing";
}

}  // namespace wend
