#include "core/mesh/formats/zip_archive.h"

#include <zlib.h>

#include <algorithm>
#include <cstdint>

#include "core/mesh/error.h"
#include "core/mesh/formats/scanner.h"

namespace wend::formats {
namespace {

constexpr std::size_t kLongestFile = std::size_t(1) << 30;
constexpr unsigned kStored = 0, kDeflated = 8;

/// Returns a little-endian number of `size` bytes.
std::size_t numberAt(std::string_view bytes, std::size_t at, std::size_t size) {
    if (at > bytes.size() || size > bytes.size() - at) throw InputError("is a damaged ZIP archive");
    std::size_t number = 0;
    for (std::size_t k = 0; k < size; ++k)
        number |= static_cast<std::size_t>(static_cast<unsigned char>(bytes[at + k])) << (8 * k);
    return number;
}

std::string lowerName(std::string_view name) {
    std::string lower(name);
    for (char& c : lower) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return lower;
}

/// Inflates the content of a file, which must have the stated size.
std::string inflated(std::string_view packed, std::size_t size, const std::string& name) {
    std::string bytes(size, '\0');
    z_stream stream{};
    if (inflateInit2(&stream, -MAX_WBITS) != Z_OK) throw InputError("cannot be unpacked");
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));
    stream.avail_in = static_cast<uInt>(packed.size());
    stream.next_out = reinterpret_cast<Bytef*>(bytes.data());
    stream.avail_out = static_cast<uInt>(size);
    const int done = inflate(&stream, Z_FINISH);
    const bool isWhole = done == Z_STREAM_END && stream.total_out == size;
    inflateEnd(&stream);
    if (!isWhole) throw InputError("has a damaged " + inQuotes(name));
    return bytes;
}

}  // namespace

/// Finds the end record behind a possible comment, and reads the central directory.
ZipArchive::ZipArchive(std::string_view bytes) : m_bytes(bytes) {
    constexpr std::string_view kEnd("PK\5\6", 4), kEntry("PK\1\2", 4);
    constexpr std::size_t kEndSize = 22, kLongestComment = 65535;
    const std::size_t from =
        bytes.size() < kEndSize + kLongestComment ? 0 : bytes.size() - kEndSize - kLongestComment;
    const std::size_t end = bytes.rfind(kEnd);
    if (end == std::string_view::npos || end < from)
        throw InputError("is no ZIP archive, which .3mf files are");
    const std::size_t count = numberAt(bytes, end + 10, 2);
    std::size_t at = numberAt(bytes, end + 16, 4);
    for (std::size_t k = 0; k < count; ++k) {
        if (numberAt(bytes, at, 4) != numberAt(kEntry, 0, 4)) throw InputError("is a damaged ZIP archive");
        const std::size_t nameSize = numberAt(bytes, at + 28, 2);
        const Entry entry{numberAt(bytes, at + 42, 4), numberAt(bytes, at + 20, 4),
                          numberAt(bytes, at + 24, 4), static_cast<unsigned>(numberAt(bytes, at + 10, 2)),
                          static_cast<unsigned>(numberAt(bytes, at + 16, 4))};
        if (nameSize > 0) numberAt(bytes, at + 46 + nameSize - 1, 1);
        m_entries.emplace(lowerName(bytes.substr(at + 46, nameSize)), entry);
        at += 46 + nameSize + numberAt(bytes, at + 30, 2) + numberAt(bytes, at + 32, 2);
    }
}

/// Reads and inflates the content of a file, and checks its length and CRC-32.
std::optional<std::string> ZipArchive::file(const std::string& name) const {
    const auto found = m_entries.find(lowerName(name));
    if (found == m_entries.end()) return std::nullopt;
    const Entry& entry = found->second;
    if (entry.unpacked > kLongestFile) throw InputError("has a " + inQuotes(name) + " of more than 1 GB");
    const std::size_t begin =
        entry.header + 30 + numberAt(m_bytes, entry.header + 26, 2) + numberAt(m_bytes, entry.header + 28, 2);
    if (begin > m_bytes.size() || entry.packed > m_bytes.size() - begin)
        throw InputError("is a damaged ZIP archive");
    const std::string_view packed = m_bytes.substr(begin, entry.packed);
    if (entry.method != kStored && entry.method != kDeflated)
        throw InputError("has a " + inQuotes(name) + " packed in a way that is not read");
    std::string bytes =
        entry.method == kStored ? std::string(packed) : inflated(packed, entry.unpacked, name);
    const auto checksum =
        crc32(0, reinterpret_cast<const Bytef*>(bytes.data()), static_cast<uInt>(bytes.size()));
    if (checksum != entry.checksum) throw InputError("has a damaged " + inQuotes(name));
    return bytes;
}

}  // namespace wend::formats
