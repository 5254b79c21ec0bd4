#include "warp/psd_file.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <utility>

#include "core/mesh/error.h"
#include "warp/byte_numbers.h"

namespace wend {
namespace {

using namespace std::string_view_literals;

constexpr std::array kBlendModes{std::pair{"norm"sv, "normal"},      std::pair{"pass"sv, "pass-through"},
                                 std::pair{"diss"sv, "dissolve"},    std::pair{"dark"sv, "darken"},
                                 std::pair{"mul "sv, "multiply"},    std::pair{"idiv"sv, "color-burn"},
                                 std::pair{"lbrn"sv, "linear-burn"}, std::pair{"lite"sv, "lighten"},
                                 std::pair{"scrn"sv, "screen"},      std::pair{"div "sv, "color-dodge"},
                                 std::pair{"lddg"sv, "plus"},        std::pair{"over"sv, "overlay"},
                                 std::pair{"sLit"sv, "soft-light"},  std::pair{"hLit"sv, "hard-light"},
                                 std::pair{"vLit"sv, "vivid-light"}, std::pair{"diff"sv, "difference"},
                                 std::pair{"smud"sv, "exclusion"},   std::pair{"hue "sv, "hue"},
                                 std::pair{"sat "sv, "saturation"},  std::pair{"colr"sv, "color"},
                                 std::pair{"lum "sv, "luminosity"}};

/// Goes through bytes of a file from front to back. Beyond their end it throws InputError without a file.
class ByteWalk {
  public:
    explicit ByteWalk(std::string bytes, bool isLarge = false)
        : m_bytes(std::move(bytes)), m_isLarge(isLarge) {}

    std::size_t left() const { return m_bytes.size() - m_at; }
    std::size_t at() const { return m_at; }
    std::string_view bytes(std::uint64_t size) {
        if (size > left()) throw InputError("is truncated or corrupt");
        m_at += size;
        return std::string_view(m_bytes).substr(m_at - size, size);
    }
    void skip(std::uint64_t size) { bytes(size); }
    std::uint32_t number(std::size_t size = 4) { return bigEndian(bytes(size), 0, size); }
    int signedNumber() { return static_cast<std::int32_t>(number()); }
    /// A length, of eight bytes in a large file (PSB).
    std::uint64_t length() {
        const std::uint64_t high = m_isLarge ? number() : 0;
        return high << 32U | number();
    }

  private:
    std::string m_bytes;
    std::size_t m_at = 0;
    bool m_isLarge;
};

/// A block of a layer or of all of them: four letters and data. Some have longer lengths in large files.
struct TaggedBlock {
    std::string_view key, data;
};
std::optional<TaggedBlock> nextBlock(ByteWalk& walk, bool isLarge) {
    constexpr std::array kLong{"LMsk"sv, "Lr16"sv, "Lr32"sv, "Layr"sv, "Mt16"sv, "Mt32"sv, "Mtrn"sv,
                               "Alph"sv, "FMsk"sv, "lnk2"sv, "FEid"sv, "FXid"sv, "PxSD"sv, "cinf"sv};
    if (walk.left() < 12) return std::nullopt;
    const std::string_view mark = walk.bytes(4), key = walk.bytes(4);
    if (mark != "8BIM" && mark != "8B64") return std::nullopt;
    const bool isLong = isLarge && std::ranges::find(kLong, key) != kLong.end();
    if (isLong) walk.skip(4);
    const std::uint32_t length = walk.number();
    return TaggedBlock{key, walk.bytes(std::min<std::size_t>(length, walk.left()))};
}

std::string utf8(std::string_view utf16) {
    std::string text;
    const auto put = [&](std::uint32_t byte) { text += static_cast<char>(byte); };
    for (std::size_t at = 0; at + 2 <= utf16.size(); at += 2) {
        std::uint32_t code = bigEndian(utf16, at, 2);
        if (code >= 0xd800 && code < 0xdc00 && at + 4 <= utf16.size()) {
            at += 2;
            code = 0x10000 + ((code - 0xd800) << 10U) + (bigEndian(utf16, at, 2) - 0xdc00);
        }
        if (code == 0) break;
        const int more = code < 0x80 ? 0 : code < 0x800 ? 1 : code < 0x10000 ? 2 : 3;
        constexpr std::array<std::uint32_t, 4> kFirst{0, 0xc0, 0xe0, 0xf0};
        put(kFirst[static_cast<std::size_t>(more)] | code >> 6U * static_cast<unsigned>(more));
        for (int k = more; k-- > 0;) put(0x80 | (code >> 6U * static_cast<unsigned>(k) & 0x3fU));
    }
    return text;
}

std::string blendMode(std::string_view key) {
    const auto known = std::ranges::find(kBlendModes, key, &std::pair<std::string_view, const char*>::first);
    return known != kBlendModes.end() ? known->second : std::string(key);
}

/// Takes what follows a layer's record: its name, and whether it is one or begins or ends a group.
bool takeExtras(ByteWalk extras, bool isLarge, PictureLayer& layer) {
    extras.skip(extras.number());  // mask
    extras.skip(extras.number());  // blending ranges
    const std::size_t length = extras.number(1);
    layer.name = extras.bytes(length);
    extras.skip(std::min<std::size_t>((4 - (length + 1) % 4) % 4, extras.left()));
    bool isLayer = true;
    while (const auto block = nextBlock(extras, isLarge)) {
        if (block->key == "luni" && block->data.size() >= 4) layer.name = utf8(block->data.substr(4));
        if (block->key == "lsct" && block->data.size() >= 4) isLayer = bigEndian(block->data) == 0;
    }
    return isLayer;
}

/// Reads records of layers: their rectangle, channels, blend mode, opacity, flags and extras.
std::vector<PictureLayer> layersIn(ByteWalk walk, bool isLarge, bool& isTransparent) {
    constexpr unsigned kHidden = 2;
    const int count = static_cast<std::int16_t>(walk.number(2));
    isTransparent = count < 0;
    std::vector<PictureLayer> layers;
    for (int k = 0; k < std::abs(count); ++k) {
        PictureLayer layer;
        layer.y = walk.signedNumber(), layer.x = walk.signedNumber();
        layer.height = walk.signedNumber() - layer.y, layer.width = walk.signedNumber() - layer.x;
        walk.skip(walk.number(2) * (isLarge ? 10U : 6U));
        walk.skip(4);
        layer.blend = blendMode(walk.bytes(4));
        layer.opacity = walk.number(1) / 255.0;
        walk.skip(1);
        layer.visible = (walk.number(1) & kHidden) == 0;
        walk.skip(1);
        if (takeExtras(ByteWalk(std::string(walk.bytes(walk.number()))), isLarge, layer))
            layers.push_back(layer);
    }
    return layers;
}

/// Whether the resources say that the picture of all layers is none: Photoshop leaves it out if asked to.
bool lacksPicture(ByteWalk resources) {
    constexpr unsigned kVersion = 1057;
    while (resources.left() >= 12 && resources.bytes(4) == "8BIM") {
        const unsigned kind = resources.number(2), name = resources.number(1);
        resources.skip(name + (name + 1) % 2);
        const std::uint32_t size = resources.number();
        const std::string_view data = resources.bytes(size);
        if (kind == kVersion && data.size() > 4) return data[4] == 0;
        resources.skip(std::min<std::size_t>(size % 2, resources.left()));
    }
    return false;
}

/// A section of layers with one of no size, whose negative count says that the picture has transparency.
std::string noLayers(bool isLarge, bool isTransparent) {
    const std::string zeros(isLarge ? 4 : 0, '\0');
    if (!isTransparent) return zeros + std::string(4, '\0');
    // The count, a rectangle and no channels; blend mode, opacity, flags; twelve bytes of empty extras.
    const std::string layer = "\xff\xff" + std::string(18, '\0') + "8BIMnorm\xff" + std::string(6, '\0') +
                              '\x0c' + std::string(12, '\0');
    const auto length = [&](std::size_t size) {
        return zeros + std::string(3, '\0') + static_cast<char>(size);
    };
    const std::string layers = length(layer.size()) + layer;
    return length(layers.size()) + layers;
}

/// The sections of a file, each after its length: colours, resources, layers, and the picture.
class PsdSections {
  public:
    explicit PsdSections(const InputFile& file) : m_file(file) {
        const std::string header = file.bytes(0, 26);
        if (header.size() < 26) throw InputError("is truncated in its header");
        m_isLarge = bigEndian(header, 4, 2) == 2;
        skip(4), skip(4);
        m_layers = m_at;
        m_layersEnd = m_layers + lengthSize() + lengthAt(m_layers);
        if (m_layersEnd > file.size()) throw InputError("is truncated before its picture");
    }

    LayeredFile read() {
        LayeredFile result;
        if (lacksPicture(ByteWalk(m_file.bytes(m_resources, m_layers - m_resources))))
            throw InputError("holds no picture of all its layers (Maximize Compatibility): save it with one");
        bool isTransparent = false;
        result.layers = layers(isTransparent);
        result.merged = m_file.bytes(0, m_layers) + noLayers(m_isLarge, isTransparent) +
                        m_file.bytes(m_layersEnd, m_file.size());
        return result;
    }

  private:
    std::size_t lengthSize() const { return m_isLarge ? 8 : 4; }
    std::uint64_t lengthAt(std::uint64_t at) const {
        return ByteWalk(m_file.bytes(at, lengthSize()), m_isLarge).length();
    }
    void skip(std::size_t lengthBytes) {
        m_resources = m_at + lengthBytes;
        m_at = m_resources + ByteWalk(m_file.bytes(m_at, lengthBytes)).number();
    }

    /// Those of 8 bits are first in the section, others in a block behind.
    std::vector<PictureLayer> layers(bool& isTransparent) const {
        if (m_layersEnd == m_layers + lengthSize()) return {};
        const std::uint64_t begin = m_layers + 2 * lengthSize(), size = lengthAt(m_layers + lengthSize());
        if (begin + size > m_layersEnd) throw InputError("is truncated or corrupt");
        if (size > 0)
            return layersIn(ByteWalk(m_file.bytes(begin, size), m_isLarge), m_isLarge, isTransparent);
        ByteWalk rest(m_file.bytes(begin, m_layersEnd - begin));
        if (rest.left() >= 4) rest.skip(std::min<std::size_t>(rest.number(), rest.left()));
        while (const auto block = nextBlock(rest, m_isLarge)) {
            if (block->key == "Lr16" || block->key == "Lr32")
                return layersIn(ByteWalk(std::string(block->data)), m_isLarge, isTransparent);
            rest.skip(std::min<std::size_t>((4 - block->data.size() % 4) % 4, rest.left()));
        }
        return {};
    }

    const InputFile& m_file;
    bool m_isLarge = false;
    std::uint64_t m_at = 26, m_resources = 0, m_layers = 0, m_layersEnd = 0;
};

}  // namespace

LayeredFile readPsdFile(const InputFile& file) try {
    return PsdSections(file).read();
} catch (const InputError& error) {
    throw error.named(file.path());
}

}  // namespace wend
