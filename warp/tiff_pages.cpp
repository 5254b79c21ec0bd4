#include "warp/tiff_pages.h"

#include <bit>
#include <cmath>
#include <string_view>

#include "warp/byte_numbers.h"
#include "warp/layered_file.h"

namespace wend {
namespace {

constexpr std::size_t kEntry = 12;  // bytes
constexpr std::uint32_t kSubfile = 254, kWidth = 256, kHeight = 257, kBits = 258, kPhotometric = 262,
                        kMake = 271, kSamples = 277, kXResolution = 282, kYResolution = 283, kPageName = 285,
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

/// The numbers of a TIFF or BigTIFF, in its byte order, with the sizes of the parts of its directories.
struct TiffForm {
    bool isLittle, isBig;

    std::size_t count() const { return isBig ? 8 : 2; }
    std::size_t entry() const { return isBig ? 20 : 12; }
    std::size_t offset() const { return isBig ? 8 : 4; }

    std::uint64_t number(std::string_view bytes, std::size_t at, std::size_t size) const {
        std::uint64_t value = 0;
        for (std::size_t k = 0; k < size; ++k)
            value = value << 8U | static_cast<unsigned char>(bytes[at + (isLittle ? size - 1 - k : k)]);
        return value;
    }
    std::string text(std::uint64_t value, std::size_t size) const {
        std::string bytes(size, '\0');
        for (std::size_t k = 0; k < size; ++k, value >>= 8U)
            bytes[isLittle ? k : size - 1 - k] = static_cast<char>(value & 0xffU);
        return bytes;
    }
};

std::optional<TiffForm> formOf(const InputFile& file) {
    const std::string head = file.bytes(0, 16);
    if (head.size() < 16) return std::nullopt;
    TiffForm form{head[0] == 'I', false};
    form.isBig = form.number(head, 2, 2) == 43;
    return form;
}

struct TiffPlace {
    std::uint64_t at;
    std::string entries;

    /// Returns where the number is that refers to the next directory.
    std::uint64_t end(const TiffForm& form) const { return at + form.count() + entries.size(); }
};

/// Returns the directories, as far as they are complete and do not refer to each other in a circle.
std::vector<TiffPlace> directoriesOf(const InputFile& file, const TiffForm& form) {
    constexpr std::size_t kMost = 1000;
    std::vector<TiffPlace> found;
    std::uint64_t pointer = form.isBig ? 8 : 4, total = 0;
    while (found.size() < kMost) {
        const std::string to = file.bytes(pointer, form.offset());
        const std::uint64_t at = to.size() < form.offset() ? 0 : form.number(to, 0, form.offset());
        const std::string count = at == 0 ? std::string() : file.bytes(at, form.count());
        if (count.size() < form.count()) break;
        const std::uint64_t entries = form.number(count, 0, form.count());
        if (entries > file.size() / form.entry()) break;
        const std::uint64_t size = entries * form.entry();
        if ((total += size) > file.size()) break;
        TiffPlace place{at, file.bytes(at + form.count(), size)};
        if (place.entries.size() < size) break;
        pointer = place.end(form);
        found.push_back(std::move(place));
    }
    return found;
}

/// Changes the entries of one directory of a TIFF.
class TiffEntries {
  public:
    TiffEntries(const TiffForm& form, std::string entries) : m_form(form), m_entries(std::move(entries)) {}

    std::optional<std::uint64_t> shortValue(std::uint32_t tag) const {
        const std::size_t at = placeOf(tag);
        if (!isAt(at, tag)) return std::nullopt;
        return m_form.number(m_entries, at + valueAt(), 2);
    }
    void setShort(std::uint32_t tag, std::uint32_t value, std::size_t count = 1) {
        const std::size_t at = placeOf(tag);
        std::string values;
        for (std::size_t k = 0; k < count; ++k) values += m_form.text(value, 2);
        values.resize(m_form.offset());
        constexpr std::uint64_t kShort = 3;
        m_entries.replace(
            at, isAt(at, tag) ? m_form.entry() : 0,
            m_form.text(tag, 2) + m_form.text(kShort, 2) + m_form.text(count, m_form.offset()) + values);
    }
    const std::string& bytes() const { return m_entries; }

  private:
    std::size_t valueAt() const { return 4 + m_form.offset(); }
    bool isAt(std::size_t at, std::uint32_t tag) const {
        return at < m_entries.size() && m_form.number(m_entries, at, 2) == tag;
    }
    /// Returns the place of the first entry that does not come before the tag.
    std::size_t placeOf(std::uint32_t tag) const {
        std::size_t at = 0;
        while (at < m_entries.size() && m_form.number(m_entries, at, 2) < tag) at += m_form.entry();
        return at;
    }

    TiffForm m_form;
    std::string m_entries;
};

/// Appends a directory, and returns its place.
std::uint64_t append(const TiffForm& form, const std::string& entries, std::string next, std::string& bytes) {
    next.resize(form.offset());
    bytes.resize(bytes.size() + bytes.size() % 2);
    const std::uint64_t at = bytes.size();
    bytes += form.text(entries.size() / form.entry(), form.count()) + entries + next;
    return at;
}

}  // namespace

PlainTiff plainTiff(const InputFile& file) {
    PlainTiff plain;
    const std::optional<TiffForm> form = formOf(file);
    if (!form) return plain;
    std::uint64_t pointer = form->isBig ? 8 : 4;  // to the next directory
    for (const TiffPlace& place : directoriesOf(file, *form)) {
        TiffEntries entries(*form, place.entries);
        plain.inverted.push_back(entries.shortValue(kPhotometric) == 0U);
        if (plain.inverted.back()) entries.setShort(kPhotometric, 1);
        const std::uint64_t samples = entries.shortValue(kSamples).value_or(1);
        if (!entries.shortValue(kBits) && samples <= form->offset() / 2)
            entries.setShort(kBits, 1, static_cast<std::size_t>(samples));
        std::uint64_t at = place.at;
        if (entries.bytes() != place.entries) {
            if (plain.bytes.empty()) plain.bytes = file.bytes();
            at = append(*form, entries.bytes(), file.bytes(place.end(*form), form->offset()), plain.bytes);
            plain.bytes.replace(pointer, form->offset(), form->text(at, form->offset()));
        }
        pointer = at + form->count() + entries.bytes().size();
    }
    return plain;
}

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
