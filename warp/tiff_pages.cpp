#include "warp/tiff_pages.h"

#include <bit>
#include <cmath>

#include "warp/byte_numbers.h"
#include "warp/layered_file.h"

namespace wend {
namespace {

constexpr std::size_t kEntry = 12;  // bytes
constexpr std::uint32_t kSubfile = 254, kWidth = 256, kHeight = 257, kPhotometric = 262, kMake = 271,
                        kSamples = 277, kXResolution = 282, kYResolution = 283, kPageName = 285,
                        kXPosition = 286, kYPosition = 287, kParts = 330, kExtraSamples = 338, kDng = 50706;

/// Returns whether the picture is a smaller copy or a mask of another one.
bool isSecondary(const TiffDirectory& page) {
    constexpr std::uint32_t kSmaller = 1, kMask = 4;
    return (page.value(kSubfile).value_or(0) & (kSmaller | kMask)) != 0;
}

bool hasAlpha(const TiffDirectory& page) {
    const std::uint32_t samples = page.value(kSamples).value_or(1);
    return samples == 2 || samples == 4;
}

/// Converts a position, which is in the unit of the resolution, to pixels.
int pixels(std::optional<double> position, std::optional<double> resolution) {
    constexpr double kFarthestPage = 1e8;
    const double place = position.value_or(0) * resolution.value_or(1);
    return std::abs(place) < kFarthestPage ? static_cast<int>(std::lround(place)) : 0;
}

PictureLayer layerOf(const TiffDirectory& page) {
    PictureLayer layer;
    layer.name = page.text(kPageName).value_or("");
    layer.x = pixels(page.real(kXPosition), page.real(kXResolution));
    layer.y = pixels(page.real(kYPosition), page.real(kYResolution));
    layer.width = static_cast<int>(page.value(kWidth).value_or(0));
    layer.height = static_cast<int>(page.value(kHeight).value_or(0));
    return layer;
}

}  // namespace

TiffDirectory::TiffDirectory(const InputFile& file, std::optional<std::uint64_t> at)
    : m_file(file), m_head(file.bytes(0, 16)) {
    constexpr std::uint32_t kClassic = 42;
    if (m_head.size() < 8) return;
    const std::uint64_t directory = at.value_or(number(m_head, 4, 4));
    const std::string count = file.bytes(directory, 2);
    if (number(m_head, 2, 2) != kClassic || count.size() < 2) return;
    const std::size_t size = kEntry * number(count, 0, 2);
    m_entries = file.bytes(directory + 2, size);
    const std::string next = file.bytes(directory + 2 + size, 4);
    if (next.size() == 4) m_next = number(next, 0, 4);
}

std::uint32_t TiffDirectory::number(const std::string& bytes, std::size_t at, std::size_t size) const {
    return m_head[0] == 'I' ? littleEndian(bytes, at, size) : bigEndian(bytes, at, size);
}

std::optional<std::size_t> TiffDirectory::entry(std::uint32_t tag) const {
    for (std::size_t at = 0; at + kEntry <= m_entries.size(); at += kEntry)
        if (number(m_entries, at, 2) == tag) return at;
    return std::nullopt;
}

std::optional<std::uint32_t> TiffDirectory::value(std::uint32_t tag) const {
    constexpr std::uint32_t kShort = 3;
    const auto at = entry(tag);
    if (!at) return std::nullopt;
    return number(m_entries, *at + 8, number(m_entries, *at + 2, 2) == kShort ? 2 : 4);
}

std::optional<double> TiffDirectory::real(std::uint32_t tag) const {
    constexpr std::uint32_t kFraction = 5, kFloat = 11;
    const auto at = entry(tag);
    if (!at) return std::nullopt;
    const std::uint32_t type = number(m_entries, *at + 2, 2), own = number(m_entries, *at + 8, 4);
    if (type == kFloat) return static_cast<double>(std::bit_cast<float>(own));
    const std::string fraction = type == kFraction ? m_file.bytes(own, 8) : std::string();
    if (fraction.size() < 8 || number(fraction, 4, 4) == 0) return std::nullopt;
    return static_cast<double>(number(fraction, 0, 4)) / number(fraction, 4, 4);
}

std::optional<std::string> TiffDirectory::text(std::uint32_t tag) const {
    constexpr std::uint32_t kText = 2, kLongest = 1000;
    const auto at = entry(tag);
    if (!at || number(m_entries, *at + 2, 2) != kText) return std::nullopt;
    const std::uint32_t length = number(m_entries, *at + 4, 4);
    std::string text = length <= 4 ? m_entries.substr(*at + 8, length)
                                   : m_file.bytes(number(m_entries, *at + 8, 4), std::min(length, kLongest));
    return text.substr(0, text.find('\0'));
}

bool TiffDirectory::isCameraRaw() const {
    constexpr std::uint32_t kSensor = 32803;
    const bool isSmall = (value(kSubfile).value_or(0) & 1U) != 0;
    return value(kDng) || value(kPhotometric) == kSensor || m_head.substr(8, 2) == "CR" ||
           (isSmall && value(kMake) && value(kParts));
}

bool TiffDirectory::namesExtraSamples() const {
    return !isKnown() || value(kExtraSamples);
}

TiffLayers tiffLayers(const InputFile& file) {
    constexpr int kMost = 1000;
    TiffLayers found;
    std::optional<std::uint64_t> at;
    for (int number = 0; number < kMost && at != 0U; ++number) {
        const TiffDirectory page(file, at);
        at = page.next();
        if (!page.isKnown() || isSecondary(page)) continue;
        found.layers.push_back(layerOf(page));
        found.pages.push_back(number);
        if (found.layers.back().name.empty() || (found.layers.size() > 1 && !hasAlpha(page))) return {};
    }
    if (found.layers.size() < 2) return {};
    std::vector<std::string*> names;
    for (PictureLayer& layer : found.layers) names.push_back(&layer.name);
    giveOwnNames(names);
    return found;
}

}  // namespace wend
