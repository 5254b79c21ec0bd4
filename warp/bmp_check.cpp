#include "warp/bmp_check.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string_view>

#include "warp/byte_numbers.h"

namespace wend {
namespace {

constexpr std::size_t kFileHeader = 14, kOldHeader = 12;  // in bytes; the old one is OS/2's
constexpr std::array<std::size_t, 6> kHeaders{kOldHeader, 40, 52, 56, 108, 124};
enum Packing : std::uint32_t { kStored, kRunsOf8, kRunsOf4, kMasks };

struct BmpHeader {
    explicit BmpHeader(std::string_view bytes)
        : pixels(littleEndian(bytes, 10, 4)),
          length(littleEndian(bytes, 14, 4)),
          isOld(length == kOldHeader) {
        const std::size_t side = isOld ? 2 : 4, after = kFileHeader + 4 + 2 * side;
        width = static_cast<std::int32_t>(littleEndian(bytes, 18, side));
        height = static_cast<std::int32_t>(littleEndian(bytes, 18 + side, side));
        planes = littleEndian(bytes, after, 2), bits = littleEndian(bytes, after + 2, 2);
        if (!isOld) packing = littleEndian(bytes, 30, 4), colours = littleEndian(bytes, 46, 4);
    }

    std::uint32_t pixels, length;
    bool isOld;
    std::int32_t width, height;  // < 0: rows from the top
    std::uint32_t planes, bits, packing = kStored, colours = 0;

    bool depthFits() const {
        constexpr std::array<std::uint32_t, 6> kDepths{1, 4, 8, 16, 24, 32};
        return planes == 1 && std::ranges::find(kDepths, bits) != kDepths.end() &&
               (bits > 8 || colours <= 1U << bits);
    }
    bool packingFits() const {
        if (packing == kRunsOf8) return bits == 8 && height > 0;
        if (packing == kRunsOf4) return bits == 4 && height > 0;
        return packing == kStored || (packing == kMasks && (bits == 16 || bits == 32));
    }
    double rows() const { return std::abs(static_cast<double>(height)); }
    /// Returns the bytes of rows that are not packed; each begins at a multiple of four.
    double stored() const { return std::ceil(width * static_cast<double>(bits) / 32) * 4 * rows(); }
};

}  // namespace

std::string bmpProblem(const InputFile& file) {
    const std::string bytes = file.bytes(0, kFileHeader + 40);
    if (bytes.size() < kFileHeader + kOldHeader) return "is truncated in its header";
    if (const std::uint32_t length = littleEndian(bytes, 14, 4);
        std::ranges::find(kHeaders, length) == kHeaders.end() ||
        (length > kOldHeader && bytes.size() < kFileHeader + 40))
        return "has a header that makes no sense";
    const BmpHeader header(bytes);
    if (header.width < 1 || header.height == 0) return "has no pixels";
    if (!header.depthFits() || !header.packingFits()) return "has a header that makes no sense";
    // Two bytes encode up to 255 packed pixels.
    const bool isPacked = header.packing == kRunsOf8 || header.packing == kRunsOf4;
    const double needed = isPacked ? header.width * header.rows() / 128 : header.stored();
    return header.pixels + needed > static_cast<double>(file.size()) ? "claims more pixels than it can hold"
                                                                     : "";
}

}  // namespace wend
