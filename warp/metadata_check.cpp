#include "warp/metadata_check.h"

#include <zlib.h>

#include <algorithm>
#include <string_view>

#include "warp/byte_numbers.h"
#include "warp/exif_check.h"

namespace wend {
namespace {

constexpr std::string_view kExif("Exif\0\0", 6);

/// Returns whether all is records: five bytes (a mark, two numbers, the length of the data), then the data.
bool iptcFits(std::string_view data) {
    while (!data.empty() && data[0] == '\x1c') {
        if (data.size() < 5) return false;
        const std::size_t size = 5 + bigEndian(data, 3, 2);
        if (size > data.size()) return false;
        data.remove_prefix(size);
    }
    return true;
}

/// Checks the first of Photoshop's resources, if it is IPTC.
bool photoshopFits(std::string_view data) {
    constexpr std::string_view mark("Photoshop 3.0\0", 14), iptc("8BIM\x04\x04", 6);
    constexpr std::size_t head = 26;
    if (data.size() < head) return false;
    if (!data.starts_with(mark) || !data.substr(mark.size()).starts_with(iptc)) return true;
    const std::size_t size = bigEndian(data, head - 2, 2);
    return size <= data.size() - head && iptcFits(data.substr(head, size));
}

/// A JPEG is a sequence of segments: 0xff, a kind, the length including its two bytes, the data. After the
/// kind "scan" come pixels, in which 0xff 0 is no segment.
class JpegSegments {
  public:
    explicit JpegSegments(std::string bytes) : m_bytes(std::move(bytes)) {}

    /// Returns the bytes if any has changed, else nothing.
    std::string mended() {
        for (std::size_t at = 2; (at = m_bytes.find('\xff', at)) != std::string::npos;) {
            at = m_bytes.find_first_not_of('\xff', at);
            if (at == std::string::npos || kindAt(at) == kEnd) break;
            at = kindAt(at) == 0 || isBare(kindAt(at)) ? at + 1 : mendSegment(at);
        }
        return m_mended ? std::move(m_bytes) : std::string();
    }

  private:
    static constexpr unsigned kEnd = 0xd9, kApp1 = 0xe1, kApp13 = 0xed;

    static bool isBare(unsigned kind) { return kind == 0x01 || (kind >= 0xd0 && kind <= 0xd8); }
    unsigned kindAt(std::size_t at) const { return static_cast<unsigned char>(m_bytes[at]); }

    /// Checks the segment at that place, and returns the place after it.
    std::size_t mendSegment(std::size_t at) {
        if (m_bytes.size() - at < 3) return m_bytes.size();
        const std::size_t length = bigEndian(m_bytes, at + 1, 2), data = at + 3;
        const std::size_t size =
            std::min<std::size_t>(std::max<std::size_t>(length, 2) - 2, m_bytes.size() - data);
        if ((kindAt(at) == kApp1 && !app1Fits(data, size)) ||
            (kindAt(at) == kApp13 && !photoshopFits(std::string_view(m_bytes).substr(data, size)))) {
            m_bytes[at] = '\xef';  // a kind that no reader uses
            m_mended = true;
        }
        return data + size;
    }

    /// Returns whether a segment is EXIF, whose entries are sanitized, or XMP, whose 28-byte name ends with
    /// zero.
    bool app1Fits(std::size_t data, std::size_t size) {
        const std::string_view text = std::string_view(m_bytes).substr(data, size);
        if (!text.starts_with(kExif)) return size > 28;
        const ExifState state = mendExif(m_bytes, data + kExif.size(), size - kExif.size());
        m_mended = m_mended || state == ExifState::Mended;
        return state != ExifState::Useless;
    }

    std::string m_bytes;
    bool m_mended = false;
};

/// Repairs the EXIF of a complete PNG (pngProblem): eight bytes and a row of chunks, each with the length of
/// its data, four letters, the data and their checksum.
std::string mendedPng(const InputFile& file) {
    constexpr std::size_t head = 8, checksum = 4;
    std::uint64_t at = 8;
    std::size_t size = 0;
    for (;; at += head + size + checksum) {
        const std::string begin = file.bytes(at, head);
        if (begin.size() < head) return {};
        size = bigEndian(begin);
        if (begin.substr(4) == "eXIf") break;
    }
    std::string bytes = file.bytes();
    const auto letters = static_cast<std::size_t>(at) + 4;
    const ExifState state = mendExif(bytes, letters + 4, size);
    if (state == ExifState::Fits) return {};
    if (state == ExifState::Useless) bytes.replace(letters, 4, "noTe");  // as any program may name its own
    const auto* summed = reinterpret_cast<const Bytef*>(bytes.data() + letters);
    const uLong sum = crc32(0, summed, static_cast<uInt>(size + 4));
    for (std::size_t k = 0; k < checksum; ++k)
        bytes[letters + 4 + size + k] = static_cast<char>(sum >> 8 * (checksum - 1 - k));
    return bytes;
}

}  // namespace

std::string bytesWithSoundMetadata(const InputFile& file, PictureFormat format) {
    switch (format) {
        case PictureFormat::Jpeg:
            return JpegSegments(file.bytes()).mended();
        case PictureFormat::Png:
            return mendedPng(file);
        default:
            return {};
    }
}

}  // namespace wend
