#include "warp/tga_check.h"

#include <algorithm>

#include "warp/byte_numbers.h"

namespace wend {
namespace {

struct TgaHeader {
    explicit TgaHeader(std::string_view head)
        : idLength(littleEndian(head, 0, 1)),
          paletteType(littleEndian(head, 1, 1)),
          type(littleEndian(head, 2, 1) & 7U),
          packed(littleEndian(head, 2, 1) & 8U),
          typeKnown((littleEndian(head, 2, 1) & ~0xbU) == 0),
          paletteFirst(littleEndian(head, 3, 2)),
          paletteLength(littleEndian(head, 5, 2)),
          paletteBits(littleEndian(head, 7, 1)),
          width(littleEndian(head, 12, 2)),
          height(littleEndian(head, 14, 2)),
          bits(littleEndian(head, 16, 1)),
          flags(littleEndian(head, 17, 1)) {}

    unsigned idLength, paletteType, type, packed;
    bool typeKnown;
    unsigned paletteFirst, paletteLength, paletteBits, width, height, bits, flags;

    bool paletteFits() const {
        if (paletteType == 0) return type != 1 && paletteFirst + paletteLength + paletteBits == 0;
        const bool known = paletteBits == 15 || paletteBits == 16 || paletteBits == 24 || paletteBits == 32;
        return paletteType == 1 && type == 1 && known && paletteLength > 0;
    }
    bool depthFits() const {
        if (type == 1) return bits == 8;
        if (type == 2) return bits == 15 || bits == 16 || bits == 24 || bits == 32;
        return type == 3 && (bits == 8 || bits == 16);
    }
    double beforePixels() const {
        const unsigned ofPalette = paletteLength * ((paletteBits + 7) / 8);
        return 18.0 + idLength + ofPalette;
    }
    /// Returns the least size of a file of these dimensions. A packet of a packed file holds up to 128
    /// pixels.
    double minSize() const {
        const int each = (bits + 7) / 8;
        const double pixels = 1.0 * width * height;
        const double stored = packed ? pixels / 128 * (1 + each) : pixels * each;
        return beforePixels() + stored;
    }
};

/// Returns the largest of that many colour indices of a byte each. A packet is a byte (its length, and
/// whether it repeats one value) and its data.
unsigned largestIndex(std::string_view data, double count, bool packed) {
    unsigned largest = 0;
    const auto take = [&](std::size_t from, std::size_t size) {
        for (std::size_t k = from; k < std::min(from + size, data.size()); ++k)
            largest = std::max(largest, littleEndian(data, k, 1));
    };
    if (!packed) {
        take(0, static_cast<std::size_t>(count));
        return largest;
    }
    for (std::size_t at = 0; count > 0 && at < data.size();) {
        const unsigned packet = littleEndian(data, at, 1), pixels = (packet & 0x7fU) + 1,
                       stored = packet & 0x80U ? 1 : pixels;
        take(at + 1, stored);
        at += 1 + stored;
        count -= pixels;
    }
    return largest;
}

}  // namespace

bool isTga(std::string_view head, double size) {
    if (head.size() < 18) return false;
    const TgaHeader header(head);
    return header.typeKnown && header.paletteFits() && header.depthFits() && header.width > 0 &&
           header.height > 0 && (header.flags & 0xc0U) == 0 && header.minSize() <= size;
}

std::string tgaProblem(const InputFile& file) {
    const TgaHeader header(file.bytes(0, 18));
    if (header.type != 1) return {};
    if (header.paletteFirst > 0)
        return "has a palette that does not begin with colour 0; such TGA pictures are not read";
    const std::string data = file.bytes(static_cast<std::uint64_t>(header.beforePixels()), file.size());
    const unsigned largest = largestIndex(data, 1.0 * header.width * header.height, header.packed > 0);
    if (largest < header.paletteLength) return {};
    return "is damaged: a pixel has colour " + std::to_string(largest) + " of a palette of " +
           std::to_string(header.paletteLength);
}

}  // namespace wend
