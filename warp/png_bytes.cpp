#include "warp/png_bytes.h"

#include <zlib.h>

#include <array>
#include <string_view>

#include "core/base/error.h"

namespace wend {
namespace {

std::string bytesOf(std::size_t value, std::size_t size) {
    std::string bytes(size, '\0');
    for (std::size_t k = size; k-- > 0; value >>= 8U) bytes[k] = static_cast<char>(value & 0xffU);
    return bytes;
}

std::string chunk(const std::string& name, const std::string& data) {
    const std::string named = name + data;
    const auto sum = crc32_z(0, reinterpret_cast<const Bytef*>(named.data()), named.size());
    return bytesOf(data.size(), 4) + named + bytesOf(sum, 4);
}

std::string zipped(std::string_view bytes) {
    uLongf length = compressBound(bytes.size());
    std::string packed(length, '\0');
    if (compress2(reinterpret_cast<Bytef*>(packed.data()), &length,
                  reinterpret_cast<const Bytef*>(bytes.data()), bytes.size(), 1) != Z_OK)
        throw InputError("cannot be unpacked");
    packed.resize(length);
    return packed;
}

}  // namespace

std::string pngBytes(const PngPixels& pixels, const std::string& profile) {
    constexpr std::array<char, 8> kMark{'\x89', 'P', 'N', 'G', '\r', '\n', '\x1a', '\n'};
    std::string rows;
    for (std::size_t at = 0; at < pixels.rows.size(); at += pixels.rowBytes())
        rows += '\0' + pixels.rows.substr(at, pixels.rowBytes());
    const int kind = (pixels.colours > 1 ? 2 : 0) + (pixels.alpha ? 4 : 0);
    const auto number = [](int value, std::size_t size) {
        return bytesOf(static_cast<std::size_t>(value), size);
    };
    const std::string header = number(pixels.width, 4) + number(pixels.height, 4) + number(pixels.bits, 1) +
                               number(kind, 1) + std::string(3, '\0');
    std::string file(kMark.begin(), kMark.end());
    file += chunk("IHDR", header);
    if (!profile.empty()) file += chunk("iCCP", "profile" + std::string(2, '\0') + zipped(profile));
    return file + chunk("IDAT", zipped(rows)) + chunk("IEND", {});
}

}  // namespace wend
