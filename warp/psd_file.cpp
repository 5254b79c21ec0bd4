#include "warp/psd_file.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string_view>
#include <utility>

#include "core/base/error.h"
#include "warp/byte_numbers.h"
#include "warp/png_bytes.h"

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
        if (size > left()) throw InputError(sentence("Core", "is truncated or corrupt"));
        m_at += size;
        return std::string_view(m_bytes).substr(m_at - size, size);
    }
    void skip(std::uint64_t size) { bytes(size); }
    std::uint32_t number(std::size_t size = 4) { return bigEndian(bytes(size), 0, size); }
    int signedNumber() { return static_cast<std::int32_t>(number()); }
    /// Reads a length, which has eight bytes in a large file (PSB).
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

/// What a layer is multiplied with: a plane in a box of the picture, one number elsewhere.
struct PsdMask {
    PixelBox box;
    int elsewhere = 255;
    bool isUsed = false;
};

PsdMask maskIn(ByteWalk walk) {
    constexpr unsigned kOff = 2;
    PsdMask mask;
    if (walk.left() < 18) return mask;
    mask.box.y = walk.signedNumber(), mask.box.x = walk.signedNumber();
    mask.box.height = walk.signedNumber() - mask.box.y, mask.box.width = walk.signedNumber() - mask.box.x;
    mask.elsewhere = static_cast<int>(walk.number(1));
    mask.isUsed = (walk.number(1) & kOff) == 0;
    return mask;
}

/// A layer's record. Groups are records, too: one below their layers, and one above with their properties.
struct LayerRecord {
    enum class Kind { Layer, GroupTop, GroupBottom };
    Kind kind = Kind::Layer;
    PictureLayer layer;
    PsdMask mask;
    std::vector<std::pair<int, std::uint64_t>> channels;  // what it is (−1: alpha, −2: mask), bytes
    std::vector<std::size_t> maskedGroups;                // the records of groups around it that have masks
};

/// Takes what follows a layer's record: its name, and whether it is one or begins or ends a group.
void takeExtras(ByteWalk extras, bool isLarge, LayerRecord& record) {
    constexpr std::uint32_t kBottom = 3;
    record.mask = maskIn(ByteWalk(std::string(extras.bytes(extras.number()))));
    extras.skip(extras.number());  // blending ranges
    const std::size_t length = extras.number(1);
    record.layer.name = extras.bytes(length);
    extras.skip(std::min<std::size_t>((4 - (length + 1) % 4) % 4, extras.left()));
    while (const auto block = nextBlock(extras, isLarge)) {
        if (block->key == "luni" && block->data.size() >= 4) record.layer.name = utf8(block->data.substr(4));
        if (block->key == "iOpa" && !block->data.empty())
            record.layer.opacity *= bigEndian(block->data, 0, 1) / 255.0;
        if (block->key == "lfx2") record.layer.leftOut.emplace_back("its effects");
        if ((block->key == "vmsk" || block->key == "vsms") && !record.mask.isUsed)
            record.layer.leftOut.emplace_back("its vector mask");
        if (block->key != "lsct" || block->data.size() < 4) continue;
        const std::uint32_t kind = bigEndian(block->data);
        // The mode of a group is with its kind: the record itself does not know passing through.
        if (kind != 0 && kind != kBottom && block->data.size() >= 12)
            record.layer.blend = blendMode(block->data.substr(8, 4));
        if (kind != 0)
            record.kind = kind == kBottom ? LayerRecord::Kind::GroupBottom : LayerRecord::Kind::GroupTop;
    }
}

LayerRecord nextRecord(ByteWalk& walk, bool isLarge) {
    constexpr unsigned kHidden = 2;
    LayerRecord record;
    PictureLayer& layer = record.layer;
    layer.y = walk.signedNumber(), layer.x = walk.signedNumber();
    layer.height = walk.signedNumber() - layer.y, layer.width = walk.signedNumber() - layer.x;
    for (unsigned left = walk.number(2); left > 0; --left) {
        const int kind = static_cast<std::int16_t>(walk.number(2));
        record.channels.emplace_back(kind, walk.length());
    }
    walk.skip(4);
    layer.blend = blendMode(walk.bytes(4));
    layer.opacity = walk.number(1) / 255.0;
    layer.clipped = walk.number(1) != 0;
    layer.visible = (walk.number(1) & kHidden) == 0;
    walk.skip(1);
    takeExtras(ByteWalk(std::string(walk.bytes(walk.number()))), isLarge, record);
    layer.ownOpacity = layer.opacity;
    return record;
}

LayerGroup groupOf(const PictureLayer& layer, int id) {
    LayerGroup group{id, layer.name, layer.blend, layer.ownOpacity, layer.visible, layer.clipped};
    group.isolated = layer.blend != "pass-through";
    return group;
}

/// Gives layers their groups, with the opacity of these, from the top down, and hides them with these.
void takeGroups(std::vector<LayerRecord>& records) {
    std::vector<PictureLayer> groups(1);
    std::vector<std::vector<std::size_t>> masked(1);
    int id = 0;
    for (auto record = records.rbegin(); record != records.rend(); ++record) {
        PictureLayer& layer = record->layer;
        const PictureLayer& group = groups.back();
        const LayerGroup own = groupOf(layer, ++id);
        layer.groups = group.groups;
        layer.opacity *= group.opacity;
        layer.visible = layer.visible && group.visible;
        layer.leftOut.insert(layer.leftOut.end(), group.leftOut.begin(), group.leftOut.end());
        if (record->kind == LayerRecord::Kind::GroupTop) {
            layer.groups.push_back(own);
            groups.push_back(PictureLayer(layer));
            masked.push_back(masked.back());
            if (record->mask.isUsed)
                masked.back().push_back(static_cast<std::size_t>(records.rend() - record) - 1);
        }
        if (record->kind == LayerRecord::Kind::GroupBottom && groups.size() > 1)
            groups.pop_back(), masked.pop_back();
        record->maskedGroups = masked.back();
    }
}

/// A section of layers: their records, from the back to the front, and behind them their pixels.
struct LayerSection {
    std::vector<LayerRecord> records;
    std::string pixels;
    bool isTransparent = false;

    std::vector<PictureLayer> layers() const {
        std::vector<PictureLayer> layers;
        for (const LayerRecord& record : records)
            if (record.kind == LayerRecord::Kind::Layer) layers.push_back(record.layer);
        return layers;
    }
    /// Returns the pixels from those of a record on.
    std::string pixelsOf(const LayerRecord& record) const {
        std::size_t at = 0;
        for (const LayerRecord& before : records) {
            if (&before == &record) break;
            for (const auto& channel : before.channels) at += channel.second;
        }
        return pixels.substr(std::min(at, pixels.size()));
    }
};

LayerSection layersIn(std::string bytes, bool isLarge) {
    ByteWalk walk(std::move(bytes), isLarge);
    LayerSection section;
    const int count = static_cast<std::int16_t>(walk.number(2));
    section.isTransparent = count < 0;
    for (int k = 0; k < std::abs(count); ++k) section.records.push_back(nextRecord(walk, isLarge));
    takeGroups(section.records);
    std::vector<std::string*> names;
    for (LayerRecord& record : section.records)
        if (record.kind == LayerRecord::Kind::Layer) names.push_back(&record.layer.name);
    giveOwnNames(names);
    section.pixels = walk.bytes(walk.left());
    return section;
}

/// Returns the data of a resource of that kind, if there is one.
std::optional<std::string> resource(std::string bytes, unsigned wanted) {
    ByteWalk resources(std::move(bytes));
    while (resources.left() >= 12 && resources.bytes(4) == "8BIM") {
        const unsigned kind = resources.number(2), name = resources.number(1);
        resources.skip(name + (name + 1) % 2);
        const std::uint32_t size = resources.number();
        const std::string_view data = resources.bytes(size);
        if (kind == wanted) return std::string(data);
        resources.skip(std::min<std::size_t>(size % 2, resources.left()));
    }
    return std::nullopt;
}

/// Returns whether the resources say that the picture of all layers is empty: Photoshop can leave it out.
bool lacksPicture(const std::string& resources) {
    constexpr unsigned kVersion = 1057;
    const auto version = resource(resources, kVersion);
    return version && version->size() > 4 && (*version)[4] == 0;
}

/// Returns a section of layers with one of no size, whose negative count says that the picture has
/// transparency.
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

/// Unpacks planes of one size, each after how it is packed: not, by runs of bytes (PackBits), or by zlib.
class PsdUnpacker {
  public:
    PsdUnpacker(int width, int height, unsigned bits, bool isLarge)
        : m_width(static_cast<std::size_t>(std::max(width, 0))),
          m_height(static_cast<std::size_t>(std::max(height, 0))),
          m_bytes(bits / 8),
          m_isLarge(isLarge) {
        if (1e-6 * static_cast<double>(m_width) * static_cast<double>(m_height) > kMaxMegapixels)
            throw InputError("has a layer of more than 400 million pixels");
    }

    std::string unpacked(ByteWalk walk) const {
        enum Coding : unsigned { Raw, Runs, Zip, ZipOfDifferences };
        const unsigned packing = walk.number(2);
        if (packing == Raw) return std::string(walk.bytes(size()));
        if (packing == Runs) return fromRuns(walk);
        if (packing > ZipOfDifferences || (packing == ZipOfDifferences && m_bytes > 2))
            throw InputError("has a layer that is packed in a way that is not known");
        std::string plane = fromZip(walk.bytes(walk.left()));
        if (packing == ZipOfDifferences) sumUp(plane);
        return plane;
    }

  private:
    std::size_t rowBytes() const { return m_width * m_bytes; }
    std::size_t size() const { return rowBytes() * m_height; }

    /// Unpacks PackBits: a number n ≥ 0 before n + 1 bytes, or −n before one that is there n + 1 times.
    std::string fromRuns(ByteWalk& walk) const {
        std::vector<std::size_t> lengths;
        for (std::size_t y = 0; y < m_height; ++y) lengths.push_back(walk.number(m_isLarge ? 4 : 2));
        std::string plane;
        for (const std::size_t length : lengths) {
            if (plane.size() > size()) break;
            ByteWalk row(std::string(walk.bytes(length)));
            while (row.left() > 0) {
                const int n = static_cast<std::int8_t>(row.number(1));
                if (n >= 0) plane += row.bytes(static_cast<std::size_t>(n) + 1);
                if (n < 0 && n != -128) plane.append(static_cast<std::size_t>(1 - n), row.bytes(1).front());
            }
        }
        if (plane.size() != size()) throw InputError(sentence("Core", "is truncated or corrupt"));
        return plane;
    }

    std::string fromZip(std::string_view packed) const {
        std::string plane(size(), '\0');
        uLongf length = plane.size();
        if (uncompress(reinterpret_cast<Bytef*>(plane.data()), &length,
                       reinterpret_cast<const Bytef*>(packed.data()), packed.size()) != Z_OK ||
            length != plane.size())
            throw InputError(sentence("Core", "is truncated or corrupt"));
        return plane;
    }

    /// Numbers are stored as differences from the one before in their row.
    void sumUp(std::string& plane) const {
        for (std::size_t at = 0; at < plane.size(); at += rowBytes()) {
            std::uint32_t sum = 0;
            for (std::size_t x = at; x < at + rowBytes(); x += m_bytes) {
                sum += bigEndian(plane, x, m_bytes);
                for (std::size_t k = 0; k < m_bytes; ++k)
                    plane[x + k] = static_cast<char>(sum >> (8 * (m_bytes - 1 - k)) & 0xffU);
            }
        }
    }

    std::size_t m_width, m_height, m_bytes;
    bool m_isLarge;
};

/// The planes of a layer, and its mask.
class PsdPlanes {
  public:
    PsdPlanes(const LayerRecord& record, const std::string& pixels, unsigned bits, bool isLarge)
        : m_box{record.layer.x, record.layer.y, record.layer.width, record.layer.height}, m_bytes(bits / 8) {
        if (m_box.width < 1 || m_box.height < 1)
            throw InputError("has an empty layer \"" + record.layer.name + '"');
        const PsdUnpacker own(m_box.width, m_box.height, bits, isLarge);
        ByteWalk walk(pixels);
        for (const auto& [kind, length] : record.channels) {
            ByteWalk packed{std::string(walk.bytes(length))};
            if (kind >= -1) m_planes[kind] = own.unpacked(std::move(packed));
        }
        applyMask(record, pixels, bits, isLarge);
    }

    /// Multiplies alpha with the mask of a layer, or of a group around it, whose pixels are these.
    void applyMask(const LayerRecord& record, const std::string& pixels, unsigned bits, bool isLarge) {
        ByteWalk walk(pixels);
        for (const auto& [kind, length] : record.channels) {
            ByteWalk packed{std::string(walk.bytes(length))};
            if (kind != kMask || !record.mask.isUsed) continue;
            const PixelBox& box = record.mask.box;
            apply(record.mask, PsdUnpacker(box.width, box.height, bits, isLarge).unpacked(std::move(packed)));
        }
    }

    /// Returns a PNG file of the planes, with this colour profile if it is not empty.
    std::string png(int colours, const std::string& profile) const {
        std::vector<std::string_view> planes;
        for (int kind = 0; kind < colours; ++kind) planes.push_back(plane(kind));
        const bool hasAlpha = m_planes.contains(-1);
        if (hasAlpha) planes.push_back(plane(-1));
        PngPixels pixels{m_box.width, m_box.height, static_cast<int>(8 * m_bytes), colours, hasAlpha, {}};
        for (std::size_t at = 0; at < size(); at += m_bytes)
            for (const std::string_view one : planes) pixels.rows += one.substr(at, m_bytes);
        return pngBytes(pixels, profile);
    }

  private:
    static constexpr int kMask = -2;

    std::size_t size() const {
        return m_bytes * static_cast<std::size_t>(m_box.width) * static_cast<std::size_t>(m_box.height);
    }
    std::string_view plane(int kind) const {
        const auto found = m_planes.find(kind);
        if (found == m_planes.end()) throw InputError(sentence("Core", "is truncated or corrupt"));
        return found->second;
    }

    /// Returns the mask's number at a pixel of the picture, with as many bits as those of the planes.
    std::uint32_t maskAt(const PsdMask& of, const std::string& mask, int x, int y) const {
        const PixelBox& box = of.box;
        if (x < box.x || y < box.y || x >= box.x + box.width || y >= box.y + box.height)
            return static_cast<std::uint32_t>(of.elsewhere) * (m_bytes == 2 ? 257U : 1U);
        const auto pixel = static_cast<std::size_t>(y - box.y) * static_cast<std::size_t>(box.width) +
                           static_cast<std::size_t>(x - box.x);
        return bigEndian(mask, pixel * m_bytes, m_bytes);
    }

    void apply(const PsdMask& of, const std::string& mask) {
        const std::uint64_t full = m_bytes == 2 ? 65535 : 255;
        std::string& alpha = m_planes[-1];
        if (alpha.empty()) alpha.assign(size(), '\xff');
        for (std::size_t at = 0, pixel = 0; at < alpha.size(); at += m_bytes, ++pixel) {
            const auto width = static_cast<std::size_t>(m_box.width);
            const std::uint64_t factor = maskAt(of, mask, m_box.x + static_cast<int>(pixel % width),
                                                m_box.y + static_cast<int>(pixel / width));
            const std::uint64_t value = (bigEndian(alpha, at, m_bytes) * factor + full / 2) / full;
            for (std::size_t k = 0; k < m_bytes; ++k)
                alpha[at + k] = static_cast<char>(value >> (8 * (m_bytes - 1 - k)) & 0xffU);
        }
    }

    PixelBox m_box;
    std::size_t m_bytes;
    std::map<int, std::string> m_planes;  // by what they are: −1 alpha, 0 … the colours
};

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
        if (lacksPicture(m_file.bytes(m_resources, m_layers - m_resources)))
            throw InputError({sentence("Core", "holds no picture of all its layers (%1): save it with one"),
                              "Maximize Compatibility"});
        const LayerSection section = layers();
        result.layers = section.layers();
        result.merged = m_file.bytes(0, m_layers) + noLayers(m_isLarge, section.isTransparent) +
                        m_file.bytes(m_layersEnd, m_file.size());
        return result;
    }

    /// Returns a PNG file of that layer.
    std::string layer(const std::string& name) {
        constexpr unsigned kGrey = 1, kRgb = 3;
        const LayerSection section = layers();
        layerNamed(section.layers(), name);
        for (const LayerRecord& record : section.records) {
            if (record.kind != LayerRecord::Kind::Layer || record.layer.name != name) continue;
            const std::string header = m_file.bytes(0, 26);
            const unsigned mode = bigEndian(header, 24, 2);
            if (mode != kGrey && mode != kRgb) throw InputError("has colours that are neither RGB nor grey");
            if (const unsigned bits = bigEndian(header, 22, 2); bits != 8 && bits != 16)
                throw InputError("has layers of " + std::to_string(bits) + " bits: only 8 and 16 are read");
            const unsigned depth = bigEndian(header, 22, 2);
            PsdPlanes planes(record, section.pixelsOf(record), depth, m_isLarge);
            for (const std::size_t group : record.maskedGroups)
                planes.applyMask(section.records[group], section.pixelsOf(section.records[group]), depth,
                                 m_isLarge);
            return planes.png(mode == kRgb ? 3 : 1, profile());
        }
        return {};
    }

  private:
    std::string profile() const {
        constexpr unsigned kProfile = 1039;
        return resource(m_file.bytes(m_resources, m_layers - m_resources), kProfile).value_or("");
    }
    std::size_t lengthSize() const { return m_isLarge ? 8 : 4; }
    std::uint64_t lengthAt(std::uint64_t at) const {
        return ByteWalk(m_file.bytes(at, lengthSize()), m_isLarge).length();
    }
    void skip(std::size_t lengthBytes) {
        m_resources = m_at + lengthBytes;
        m_at = m_resources + ByteWalk(m_file.bytes(m_at, lengthBytes)).number();
    }

    /// Those of 8 bits are first in the section, others in a block behind.
    LayerSection layers() const {
        if (m_layersEnd == m_layers + lengthSize()) return {};
        const std::uint64_t begin = m_layers + 2 * lengthSize(), size = lengthAt(m_layers + lengthSize());
        if (begin + size > m_layersEnd) throw InputError(sentence("Core", "is truncated or corrupt"));
        if (size > 0) return layersIn(m_file.bytes(begin, size), m_isLarge);
        ByteWalk rest(m_file.bytes(begin, m_layersEnd - begin));
        if (rest.left() >= 4) rest.skip(std::min<std::size_t>(rest.number(), rest.left()));
        while (const auto block = nextBlock(rest, m_isLarge)) {
            if (block->key == "Lr16" || block->key == "Lr32")
                return layersIn(std::string(block->data), m_isLarge);
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

std::string readPsdLayer(const InputFile& file, const std::string& name) try {
    return PsdSections(file).layer(name);
} catch (const InputError& error) {
    throw error.named(file.path());
}

}  // namespace wend
