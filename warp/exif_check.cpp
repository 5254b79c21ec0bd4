#include "warp/exif_check.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <set>
#include <string_view>

#include "warp/byte_numbers.h"

namespace wend {
namespace {

constexpr std::size_t kExifEntry = 12, kMaxValue = 0x10000;  // in bytes
constexpr unsigned kMakerNote = 0x927c;
constexpr std::array kDirectories{0x8769U, 0x8825U, 0xa005U};  // EXIF, GPS, interoperability

/// A meaningless number of type BYTE under an unknown tag.
constexpr std::string_view kUnknown("\xff\xff\0\1\0\0\0\1\0\0\0\0", kExifEntry);
constexpr std::string_view kUnknownLittle("\xff\xff\1\0\1\0\0\0\0\0\0\0", kExifEntry);

class ExifBlock {
  public:
    ExifBlock(std::string& bytes, std::size_t from, std::size_t size)
        : m_bytes(bytes), m_from(from), m_size(size) {}

    ExifState mend() {
        const std::string_view mark = std::string_view(m_bytes).substr(m_from, std::min(m_size, 4UL));
        m_big = mark == std::string_view("MM\0*", 4);
        if (m_size < 8 || !(m_big || mark == std::string_view("II*\0", 4))) return ExifState::Useless;
        if (!mendDirectory(number(4, 4))) return ExifState::Useless;
        return m_mended ? ExifState::Mended : ExifState::Fits;
    }

  private:
    std::uint32_t number(std::size_t at, std::size_t size) const {
        return m_big ? bigEndian(m_bytes, m_from + at, size) : littleEndian(m_bytes, m_from + at, size);
    }

    /// Returns the number of entries of a directory; 0 if it is not completely inside.
    std::size_t entriesOf(std::size_t at) const {
        if (at > m_size || m_size - at < 2) return 0;
        const std::size_t count = number(at, 2);
        return count * kExifEntry <= m_size - at - 2 ? count : 0;
    }

    /// Returns false if it is missing or was visited before.
    bool mendDirectory(std::size_t at) {
        const std::size_t count = entriesOf(at);
        if (count == 0 || !m_seen.insert(at).second) return false;
        for (std::size_t k = 0; k < count; ++k)
            if (const std::size_t entry = at + 2 + kExifEntry * k; !keeps(entry)) {
                m_bytes.replace(m_from + entry, kExifEntry, m_big ? kUnknown : kUnknownLittle);
                m_mended = true;
            }
        return true;
    }

    bool valueFits(std::size_t entry) const {
        constexpr std::array<std::size_t, 13> sizes{0, 1, 1, 2, 4, 8, 1, 1, 2, 4, 8, 4, 8};  // by type
        const std::size_t type = number(entry + 2, 2), count = number(entry + 4, 4);
        if (type == 0 || type >= sizes.size() || count == 0) return false;
        const std::size_t size = count * sizes[type], at = number(entry + 8, 4);
        return size <= 4 || (size <= kMaxValue && at <= m_size && size <= m_size - at);
    }

    /// Checks a camera's own directory, which is read for Canon's.
    bool directoryFits(std::size_t at) const {
        const std::size_t count = entriesOf(at);
        for (std::size_t k = 0; k < count; ++k)
            if (!valueFits(at + 2 + kExifEntry * k)) return false;
        return count > 0;
    }

    bool keeps(std::size_t entry) {
        const std::uint32_t tag = number(entry, 2);
        if (!valueFits(entry)) return false;
        if (std::ranges::find(kDirectories, tag) != kDirectories.end())
            return mendDirectory(number(entry + 8, 4));
        return tag != kMakerNote || directoryFits(number(entry + 8, 4));
    }

    std::string& m_bytes;
    std::size_t m_from, m_size;
    bool m_big = false, m_mended = false;
    std::set<std::size_t> m_seen;  // directories
};

}  // namespace

ExifState mendExif(std::string& bytes, std::size_t from, std::size_t size) {
    return ExifBlock(bytes, from, size).mend();
}

}  // namespace wend
