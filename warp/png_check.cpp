#include "warp/png_check.h"

#include <array>
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

}  // namespace

std::string pngProblem(const std::string& path, std::uint64_t rawBytes) {
    std::ifstream file(path, std::ios::binary);
    if (!isPng(file)) return {};
    file.seekg(0, std::ios::end);
    const auto size = static_cast<std::uint64_t>(file.tellg());
    std::uint64_t position = 8, compressed = 0;
    for (std::array<unsigned char, 8> head{}; position + 12 <= size;) {
        file.seekg(static_cast<std::streamoff>(position));
        file.read(reinterpret_cast<char*>(head.data()), 8);
        const std::string name(reinterpret_cast<char*>(head.data()) + 4, 4);
        const std::uint64_t length = bigEndian(head.data());
        position += 12 + length;
        if (name == "IDAT") compressed += length;
        if (position > size) return "is truncated in chunk " + name;
        // Deflate packs at most 1032 bytes into one.
        if (name == "IEND") return rawBytes / 1032 > compressed ? "claims more pixels than it can hold" : "";
    }
    return "is truncated: its end is missing";
}

}  // namespace wend
