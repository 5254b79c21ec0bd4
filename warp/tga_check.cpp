#include "warp/tga_check.h"

#include <algorithm>

namespace wend {
namespace {

unsigned byteAt(std::string_view bytes, std::size_t at) {
    return static_cast<unsigned char>(bytes[at]);
}
unsigned wordAt(std::string_view bytes, std::size_t at) {
    return byteAt(bytes, at) | byteAt(bytes, at + 1) << 8;
}

struct TgaHeader {
    explicit TgaHeader(std::string_view head)
        : idLength(byteAt(head, 0)),
          paletteType(byteAt(head, 1)),
          type(byteAt(head, 2) & 7U),
          packed(byteAt(head, 2) & 8U),
          typeKnown((byteAt(head, 2) & ~0xbU) == 0),
          paletteFirst(wordAt(head, 3)),
          paletteLength(wordAt(head, 5)),
          paletteBits(byteAt(head, 7)),
          width(wordAt(head, 12)),
          height(wordAt(head, 14)),
          bits(byteAt(head, 16)),
          flags(byteAt(head, 17)) {}

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
    /// The least that a file with it has. A packet of a packed file holds up to 128 pixels.
    double minSize() const {
        const int each = (bits + 7) / 8;
        const double pixels = 1.0 * width * height;
        const double stored = packed ? pixels / 128 * (1 + each) : pixels * each;
        return beforePixels() + stored;
    }
};

/// The largest of so many numbers of colours, of a byte each. A packet is a byte (how many, and whether they
/// are one and the same) and what it says.
unsigned largestIndex(std::string_view data, double count, bool packed) {
    unsigned largest = 0;
    const auto take = [&](std::size_t from, std::size_t size) {
        for (std::size_t k = from; k < std::min(from + size, data.size()); ++k)
            largest = std::max(largest, byteAt(data, k));
    };
    if (!packed) {
        take(0, static_cast<std::size_t>(count));
        return largest;
    }
    for (std::size_t at = 0; count > 0 && at < data.size();) {
        const unsigned packet = byteAt(data, at), pixels = (packet & 0x7fU) + 1,
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
