#include "warp/photoshop_file.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <pugixml.hpp>
#include <span>
#include <string_view>

#include "core/base/checked_file.h"
#include "core/base/error.h"
#include "core/base/safe_file.h"
#include "warp/colour_space.h"
#include "warp/convert.h"

namespace wend {
namespace {

constexpr int kLongestSide = 30000;
constexpr std::size_t kLongestName = 255;  // in units of UTF-16

/// Writes numbers, the most significant byte first, and the lengths of sections once these are complete.
class PsdFile {
  public:
    /// `path` is the one that errors name.
    PsdFile(const std::string& path, const std::string& temporary) : m_path(path), m_file(temporary) {}

    void put(std::string_view bytes) {
        constexpr std::int64_t kLargest = std::numeric_limits<std::int32_t>::max();
        if (at() + static_cast<std::int64_t>(bytes.size()) > kLargest)
            throw InputError(
                m_path,
                sentence("Core",
                         "cannot be written: a Photoshop file has at most 2 GB, these layers have more"));
        m_file.write(at(), bytes.data(), bytes.size());
        if (m_file.failed()) finish();
    }
    void put(std::int64_t number, std::size_t size) { put(bytesOf(number, size)); }
    void zeros(std::size_t count) { put(std::string(count, '\0')); }
    std::int64_t at() const { return m_file.size(); }
    void replace(std::int64_t place, std::string_view bytes) {
        m_file.write(place, bytes.data(), bytes.size());
    }

    /// Writes a section with its length before it: that of a multiple of `unit` bytes.
    template <class Write>
    void section(std::int64_t unit, const Write& write) {
        const std::int64_t begin = at() + 4;
        zeros(4);
        write();
        zeros(static_cast<std::size_t>((unit - (at() - begin) % unit) % unit));
        replace(begin - 4, bytesOf(at() - begin, 4));
    }
    void finish() {
        if (const std::string problem = m_file.finish(); !problem.empty())
            throw InputError(m_path, {sentence("Core", "cannot be written: %1"), problem});
    }

    static std::string bytesOf(std::int64_t number, std::size_t size) {
        std::string bytes;
        for (std::size_t k = size; k-- > 0;)
            bytes += static_cast<char>(static_cast<std::uint64_t>(number) >> (8 * k));
        return bytes;
    }

  private:
    std::string m_path;
    CheckedFile m_file;
};

/// Packs bytes (PackBits): n − 1 before n others, or 1 − n before one that is there n times.
void appendPacked(std::string_view bytes, std::string& packed) {
    constexpr std::size_t kMost = 128;
    const auto runAt = [&](std::size_t at) {
        std::size_t end = at + 1;
        while (end < bytes.size() && end - at < kMost && bytes[end] == bytes[at]) ++end;
        return end - at;
    };
    for (std::size_t at = 0; at < bytes.size();) {
        const std::size_t run = runAt(at);
        if (run > 2) {
            packed += static_cast<char>(1 - static_cast<int>(run));
            packed += bytes[at];
            at += run;
            continue;
        }
        std::size_t end = at + run;
        while (end < bytes.size() && end - at < kMost && runAt(end) < 3) ++end;
        packed += static_cast<char>(end - at - 1);
        packed += bytes.substr(at, end - at);
        at = end;
    }
}

/// Returns one channel of a row.
std::string planeRow(const Image& picture, int y, int channel) {
    const std::size_t size = picture.pixelBytes() / static_cast<std::size_t>(picture.channels);
    const auto* from =
        reinterpret_cast<const char*>(picture.row(y)) + size * static_cast<std::size_t>(channel);
    std::string row;
    row.reserve(size * static_cast<std::size_t>(picture.width));
    for (int x = 0; x < picture.width; ++x, from += picture.pixelBytes()) {
        if (size == 1) {
            row += *from;
        } else {
            std::uint16_t number{};
            std::copy_n(from, 2, reinterpret_cast<char*>(&number));
            row += static_cast<char>(number >> 8U);
            row += static_cast<char>(number & 0xffU);
        }
    }
    return row;
}

/// Writes packed rows behind their lengths, which precede the rows of all planes.
class PackedRows {
  public:
    PackedRows(PsdFile& file, std::int64_t count) : m_file(file), m_at(file.at() + 2) {
        constexpr int kRuns = 1;
        file.put(kRuns, 2);
        file.zeros(static_cast<std::size_t>(2 * count));
    }
    void add(const Image& picture, int channel) {
        for (int y = 0; y < picture.height; ++y) {
            m_packed.clear();
            appendPacked(planeRow(picture, y, channel), m_packed);
            m_file.put(m_packed);
            m_lengths += PsdFile::bytesOf(static_cast<std::int64_t>(m_packed.size()), 2);
        }
    }
    void finish() { m_file.replace(m_at, m_lengths); }

  private:
    PsdFile& m_file;
    std::int64_t m_at;
    std::string m_lengths, m_packed;
};

std::u16string utf16(const std::string& utf8) {
    std::u16string text;
    for (const wchar_t letter : pugi::as_wide(utf8)) {
        auto code = static_cast<std::uint32_t>(letter);
        const bool isPair = code > 0xffff;
        if (text.size() + (isPair ? 2 : 1) > kLongestName) break;
        if (isPair) {
            code -= 0x10000;
            text += static_cast<char16_t>(0xd800 + (code >> 10U));
            code = 0xdc00 + (code & 0x3ffU);
        }
        text += static_cast<char16_t>(code);
    }
    return text;
}

const char* blendKey(BlendMode mode) {
    switch (mode) {
        case BlendMode::Multiply:
            return "mul ";
        case BlendMode::Screen:
            return "scrn";
        case BlendMode::Add:
            return "lddg";
        case BlendMode::Normal:
            break;
    }
    return "norm";
}

/// The section of layers and the picture of all of them, in one layout.
class PsdLayers {
  public:
    PsdLayers(PsdFile& file, const std::vector<LayerToWrite>& layers, const Image& merged,
              const PixelLayout& layout)
        : m_file(file), m_layers(layers), m_merged(merged), m_layout(layout) {}

    void putLayers() {
        m_file.section(4, [&] {
            m_file.section(4, [&] { putRecordsAndPixels(); });
            m_file.zeros(4);  // no masks of all layers
        });
    }

    /// Photoshop keeps colours over white, and the transparency as a plane of its own.
    void putMerged() {
        const int colours = m_layout.channels - 1;
        PackedRows rows(m_file,
                        static_cast<std::int64_t>(m_merged.height) * (colours + (m_merged.alpha ? 1 : 0)));
        const Image overWhite = converted(m_merged, {m_layout.type, colours, false, false});
        for (int c = 0; c < colours; ++c) rows.add(overWhite, c);
        if (m_merged.alpha) rows.add(converted(m_merged, m_layout), colours);
        rows.finish();
    }

  private:
    /// From the back to the front. A negative number of layers says that the picture has transparency.
    void putRecordsAndPixels() {
        const auto count = static_cast<std::int64_t>(m_layers.size());
        m_file.put(m_merged.alpha ? -count : count, 2);
        std::vector<std::int64_t> lengths;
        for (std::size_t k = m_layers.size(); k-- > 0;) lengths.push_back(putRecord(m_layers[k]));
        for (std::size_t k = m_layers.size(); k-- > 0;) {
            const Image picture = converted(m_layers[k].picture, m_layout);
            std::int64_t place = lengths[m_layers.size() - 1 - k];
            for (int c = -1; c < m_layout.channels - 1; ++c, place += kChannelBytes) {
                const std::int64_t begin = m_file.at();
                PackedRows rows(m_file, picture.height);
                rows.add(picture, c < 0 ? m_layout.channels - 1 : c);
                rows.finish();
                m_file.replace(place, PsdFile::bytesOf(m_file.at() - begin, 4));
            }
        }
    }

    /// Returns the place of the length of the first channel.
    std::int64_t putRecord(const LayerToWrite& layer) {
        constexpr int kAlways = 8, kHidden = 2;
        const Image& picture = layer.picture;
        for (const int side : {layer.y, layer.x, layer.y + picture.height, layer.x + picture.width})
            m_file.put(side, 4);
        m_file.put(m_layout.channels, 2);
        const std::int64_t lengths = m_file.at() + 2;
        for (int c = -1; c < m_layout.channels - 1; ++c) {
            m_file.put(c, 2);
            m_file.zeros(4);
        }
        m_file.put("8BIM");
        m_file.put(blendKey(layer.blend));
        m_file.put(std::lround(255 * std::clamp(layer.opacity, 0.0, 1.0)), 1);
        m_file.put(0, 1);  // not clipped
        m_file.put(kAlways | (layer.visible ? 0 : kHidden), 1);
        m_file.put(0, 1);
        m_file.section(4, [&] {
            m_file.zeros(8);  // no mask, no blending ranges
            putName(utf16(layer.name));
        });
        return lengths;
    }

    /// Writes the name in ASCII, and then whole.
    void putName(const std::u16string& name) {
        std::string ascii;
        for (const char16_t unit : name)
            if (unit < 0xdc00 || unit > 0xdfff) ascii += unit < 0x80 ? static_cast<char>(unit) : '?';
        ascii.insert(ascii.begin(), static_cast<char>(ascii.size()));
        ascii.resize((ascii.size() + 3) / 4 * 4);
        m_file.put(ascii);
        m_file.put("8BIMluni");
        m_file.section(4, [&] {
            m_file.put(static_cast<std::int64_t>(name.size()), 4);
            for (const char16_t unit : name) m_file.put(unit, 2);
        });
    }

    static constexpr std::int64_t kChannelBytes = 6;  // of a channel in a record

    PsdFile& m_file;
    const std::vector<LayerToWrite>& m_layers;
    const Image& m_merged;
    PixelLayout m_layout;
};

void putHeader(PsdFile& file, const Image& merged, const PixelLayout& layout) {
    constexpr int kGrey = 1, kRgb = 3, kVersion = 1;
    file.put("8BPS");
    file.put(kVersion, 2);
    file.zeros(6);
    file.put(layout.channels - (merged.alpha ? 0 : 1), 2);
    file.put(merged.height, 4);
    file.put(merged.width, 4);
    file.put(layout.type == PixelType::UInt8 ? 8 : 16, 2);
    file.put(layout.channels == 2 ? kGrey : kRgb, 2);
    file.zeros(4);  // no palette
}

/// Returns the profile of the picture. Without one its numbers are sRGB, or light if they are floats; other
/// programs have other ideas of such pictures.
std::vector<std::byte> profileOf(const Image& merged, bool isGrey) {
    constexpr std::ptrdiff_t kColours = 16;
    std::vector<std::byte> profile = merged.iccProfile();
    const std::string_view wanted = isGrey ? "GRAY" : "RGB ";
    const auto fits = [&](char letter, std::byte byte) { return static_cast<std::byte>(letter) == byte; };
    if (std::ssize(profile) >= kColours + 4 &&
        std::ranges::equal(wanted, std::span(profile).subspan(kColours, 4), fits))
        return profile;
    const bool isLight = merged.type == PixelType::Half || merged.type == PixelType::Float;
    ColourSpace space;
    space.curve = isLight ? ColourSpace::Curve::Power : ColourSpace::Curve::Srgb;
    space.name = isLight ? "Linear sRGB" : "sRGB";
    return iccProfileOf(space, isGrey);
}

void putResources(PsdFile& file, const Image& merged, const PixelLayout& layout) {
    constexpr int kProfile = 1039;
    const std::vector<std::byte> profile = profileOf(merged, layout.channels == 2);
    const std::string_view bytes(reinterpret_cast<const char*>(profile.data()), profile.size());
    file.section(2, [&] {
        file.put("8BIM");
        file.put(kProfile, 2);
        file.zeros(2);  // no name
        file.put(static_cast<std::int64_t>(bytes.size()), 4);
        file.put(bytes);
    });
}

}  // namespace

void writePhotoshopFile(const std::string& path, const std::vector<LayerToWrite>& layers, const Image& merged,
                        std::optional<PixelType> type) {
    if (std::max(merged.width, merged.height) > kLongestSide)
        throw InputError(
            path, sentence("Core", "cannot be written: a Photoshop file has at most 30000 pixels a side"));
    const bool isGrey = merged.colours() == 1 && std::ranges::all_of(layers, [](const LayerToWrite& layer) {
                            return layer.picture.colours() == 1;
                        });
    const bool isNarrow = type.value_or(merged.type) == PixelType::UInt8;
    const PixelLayout layout{isNarrow ? PixelType::UInt8 : PixelType::UInt16, isGrey ? 2 : 4, true, true};
    writeWhole(path, [&](const std::string& temporary) {
        PsdFile file(path, temporary);
        putHeader(file, merged, layout);
        putResources(file, merged, layout);
        PsdLayers sections(file, layers, merged, layout);
        sections.putLayers();
        sections.putMerged();
        file.finish();
    });
}

}  // namespace wend
