#include "warp/png_check.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "warp/byte_numbers.h"

namespace wend {
namespace {

constexpr double kExpanded = 64e6;  // bytes of scanlines up to which the compressed data is tried

using Problem = InputError;  // without the file's name

struct Header {
    std::uint64_t width = 0, height = 0, depth = 0, type = 0, interlaced = 0;

    unsigned bitsPerPixel() const {
        constexpr std::array<unsigned, 7> channels{1, 0, 3, 1, 2, 0, 4};  // by colour type
        return static_cast<unsigned>(depth) * channels[type];
    }
    bool hasKnownType() const {
        const auto depthIs = [this](std::initializer_list<unsigned> known) {
            return std::ranges::find(known, depth) != known.end();
        };
        if (type == 0) return depthIs({1, 2, 4, 8, 16});
        if (type == 3) return depthIs({1, 2, 4, 8});
        return (type == 2 || type == 4 || type == 6) && depthIs({8, 16});
    }
};

Header parsedHeader(std::string_view data) {
    const auto byte = [&](std::size_t at) { return static_cast<unsigned char>(data[at]); };
    const Header header{bigEndian(data), bigEndian(data, 4), byte(8), byte(9), byte(12)};
    if (header.width < 1 || header.height < 1) throw Problem("has no pixels");
    if (std::max(header.width, header.height) > 1000000)
        throw Problem("has more than a million pixels a side");
    if (!header.hasKnownType() || byte(10) != 0 || byte(11) != 0 || header.interlaced > 1)
        throw Problem("has a header that makes no sense");
    return header;
}

/// Scanlines of equal length; an interlaced picture has seven sets. A filter byte precedes each.
struct Rows {
    std::uint64_t count, bytes;
};

std::vector<Rows> rowsOf(const Header& header) {
    struct Pass {
        unsigned x, y, stepX, stepY;
    };
    constexpr std::array<Pass, 7> passes{
        {{0, 0, 8, 8}, {4, 0, 8, 8}, {0, 4, 4, 8}, {2, 0, 4, 4}, {0, 2, 2, 4}, {1, 0, 2, 2}, {0, 1, 1, 2}}};
    const auto rows = [&](std::uint64_t width, std::uint64_t height) -> Rows {
        return {width == 0 ? 0 : height, 1 + (width * header.bitsPerPixel() + 7) / 8};
    };
    if (header.interlaced == 0) return {rows(header.width, header.height)};
    std::vector<Rows> all;
    for (const Pass& pass : passes)
        all.push_back(rows((header.width + pass.stepX - 1 - pass.x) / pass.stepX,
                           (header.height + pass.stepY - 1 - pass.y) / pass.stepY));
    return all;
}

double bytesIn(const std::vector<Rows>& all) {
    double bytes = 0;
    for (const Rows& rows : all) bytes += static_cast<double>(rows.count) * static_cast<double>(rows.bytes);
    return bytes;
}

/// Expands the scanlines for their filters' numbers alone.
class Trial {
  public:
    explicit Trial(std::vector<Rows> rows) : m_rows(std::move(rows)), m_buffer(1 << 16) {
        if (inflateInit(&m_stream) != Z_OK) throw std::bad_alloc();
    }
    Trial(const Trial&) = delete;
    Trial& operator=(const Trial&) = delete;
    ~Trial() { inflateEnd(&m_stream); }

    void feed(std::string data) {
        m_stream.next_in = reinterpret_cast<Bytef*>(data.data());
        m_stream.avail_in = static_cast<uInt>(data.size());
        while (!m_ended) {
            m_stream.next_out = m_buffer.data();
            m_stream.avail_out = static_cast<uInt>(m_buffer.size());
            const int status = inflate(&m_stream, Z_NO_FLUSH);
            const bool damaged = status != Z_OK && status != Z_STREAM_END && status != Z_BUF_ERROR;
            if (damaged && !done()) throw Problem("has pixels whose compressed data is damaged");
            m_ended = damaged || status == Z_STREAM_END;
            const std::size_t made = m_buffer.size() - m_stream.avail_out;
            pass(made);
            if (made < m_buffer.size()) break;
        }
    }
    /// Returns whether all scanlines and the end of the compressed data exist, which libpng requires; damage
    /// after the scanlines counts as the end.
    bool isWhole() { return done() && m_ended; }

  private:
    bool done() {
        while (m_set < m_rows.size() && m_row == m_rows[m_set].count) ++m_set, m_row = 0;
        return m_set == m_rows.size();
    }
    /// Looks at the first byte of every scanline among those that were made.
    void pass(std::size_t made) {
        for (std::size_t at = 0; at < made && !done();) {
            if (m_inRow == 0 && m_buffer[at] > 4)
                throw Problem("has pixels whose compressed data is damaged");
            const std::uint64_t step = std::min<std::uint64_t>(m_rows[m_set].bytes - m_inRow, made - at);
            at += step, m_inRow += step;
            if (m_inRow < m_rows[m_set].bytes) continue;
            m_inRow = 0, ++m_row;
        }
    }

    std::vector<Rows> m_rows;
    std::vector<Bytef> m_buffer;
    z_stream m_stream{};
    std::size_t m_set = 0;
    std::uint64_t m_row = 0, m_inRow = 0;
    bool m_ended = false;
};

class Walk {
  public:
    explicit Walk(const InputFile& file) : m_file(file) {}

    void run() {
        for (std::uint64_t position = 8; !m_ended;) {
            if (position + 12 > m_file.size()) throw Problem("is truncated: its end is missing");
            const std::string head = m_file.bytes(position, 8), name = head.substr(4);
            const std::uint64_t length = bigEndian(head);
            if (position + 12 + length > m_file.size()) throw Problem("is truncated in chunk " + name);
            take(name, position, length);
            position += 12 + length;
        }
        // Deflate packs at most 1032 bytes into one.
        if (bytesIn(rowsOf(*m_header)) / 1032 > m_compressed + 1)
            throw Problem("claims more pixels than it can hold");
        if (m_trial && !m_trial->isWhole()) throw Problem("has too few data for its pixels");
    }

  private:
    void take(const std::string& name, std::uint64_t position, std::uint64_t length) {
        if (!m_header && name != "IHDR") throw Problem("does not begin with its header");
        if (!std::ranges::all_of(name, [](unsigned char c) { return std::isalpha(c) != 0; }))
            throw Problem("has a chunk " + name + ", which is no name of one");
        if (std::islower(static_cast<unsigned char>(name[0]))) {
            m_dataEnded = m_dataBegan;  // optional data is not checked
            return;
        }
        requireChecksum(name, position, length);
        if (name == "IHDR") return takeHeader(position, length);
        if (name == "PLTE") return takePalette(length);
        if (name == "IDAT") return takeData(position, length);
        if (name != "IEND") throw Problem("needs a chunk " + name + " that is not known");
        if (m_compressed == 0) throw Problem("holds no pixels");
        m_ended = true;
    }
    void requireChecksum(const std::string& name, std::uint64_t position, std::uint64_t length) const {
        uLong sum = crc32(0, nullptr, 0);
        for (std::uint64_t at = 4; at < length + 8;) {
            const std::string part =
                m_file.bytes(position + at, std::min<std::uint64_t>(length + 8 - at, kPart));
            sum = crc32(sum, reinterpret_cast<const Bytef*>(part.data()), static_cast<uInt>(part.size()));
            at += std::max<std::size_t>(part.size(), 1);
        }
        if (sum != bigEndian(m_file.bytes(position + 8 + length, 4)))
            throw Problem("is damaged in chunk " + name + ": its checksum is another");
    }
    void takeHeader(std::uint64_t position, std::uint64_t length) {
        if (m_header || length != 13) throw Problem("has a header that makes no sense");
        m_header = parsedHeader(m_file.bytes(position + 8, 13));
        if (const auto rows = rowsOf(*m_header); bytesIn(rows) <= kExpanded) m_trial.emplace(rows);
    }
    void takePalette(std::uint64_t length) {
        const bool sound = length > 0 && length <= 768 && length % 3 == 0;
        if (m_palette || (m_header->type == 3 && !sound)) throw Problem("has a palette that makes no sense");
        m_palette = true;
        m_dataEnded = m_dataBegan;
    }
    void takeData(std::uint64_t position, std::uint64_t length) {
        if (m_header->type == 3 && !m_palette) throw Problem("has no palette");
        if (m_dataEnded) throw Problem("has its pixels in pieces apart from each other");
        m_dataBegan = true;
        m_compressed += static_cast<double>(length);
        for (std::uint64_t at = 0; m_trial && at < length; at += kPart)
            m_trial->feed(m_file.bytes(position + 8 + at, std::min(length - at, kPart)));
    }

    static constexpr std::uint64_t kPart = 1 << 20;

    const InputFile& m_file;
    std::optional<Header> m_header;
    std::optional<Trial> m_trial;
    double m_compressed = 0;
    bool m_palette = false, m_dataBegan = false, m_dataEnded = false, m_ended = false;
};

}  // namespace

std::string pngProblem(const InputFile& file) try {
    Walk(file).run();
    return {};
} catch (const Problem& problem) {
    return problem.reason();
}

}  // namespace wend
