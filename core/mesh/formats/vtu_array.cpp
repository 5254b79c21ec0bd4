#include "core/mesh/formats/vtu_array.h"

#include <lz4.h>
#include <lzma.h>
#include <zlib.h>

#include <algorithm>
#include <numeric>
#include <vector>

#include "core/base/error.h"
#include "core/mesh/formats/base64.h"

namespace wend::formats {
namespace {

constexpr std::pair<std::string_view, Scalar> kScalars[] = {
    {"Int8", Scalar::Int8},      {"UInt8", Scalar::UInt8},   {"Int16", Scalar::Int16},
    {"UInt16", Scalar::UInt16},  {"Int32", Scalar::Int32},   {"UInt32", Scalar::UInt32},
    {"Int64", Scalar::Int64},    {"UInt64", Scalar::UInt64}, {"Float32", Scalar::Float32},
    {"Float64", Scalar::Float64}};

constexpr std::size_t blockSize = 1 << 15;  // VTK's

/// Returns a bound of the bytes that one compressed byte can become. It shows a damaged header before memory
/// is allocated for what that claims.
std::size_t maxRatio(VtuEncoding::Compressor compressor) {
    if (compressor == VtuEncoding::Compressor::Lz4) return 256;
    return compressor == VtuEncoding::Compressor::Lzma ? 16384 : 1032;
}

/// Takes pieces off the front of the data, each of which is base64 for itself or raw.
class Pieces {
  public:
    Pieces(std::string_view text, bool base64) : m_text(text), m_base64(base64) {}

    std::string take(std::size_t size) {
        auto bytes = peek(size);
        m_text.remove_prefix(lengthOf(size));
        return bytes;
    }
    std::string peek(std::size_t size) const {
        if (size > m_text.size()) throw InputError("the data ends too early");
        auto bytes =
            m_base64 ? decodeBase64(m_text.substr(0, lengthOf(size))) : std::string(m_text.substr(0, size));
        if (bytes.size() < size) throw InputError("the data ends too early");
        bytes.resize(size);
        return bytes;
    }

    /// Returns whether the first piece is encoded on its own although more follows: its padding leaves no
    /// room for more. (Padding alone is no proof, because it may belong to the data in the same piece.)
    bool closedAfter(std::size_t size) const {
        const auto length = lengthOf(size);
        return m_base64 && m_text.size() > length && decodeBase64(m_text.substr(0, length)).size() == size;
    }

  private:
    std::size_t lengthOf(std::size_t size) const {
        return m_base64 ? std::min((size + 2) / 3 * 4, m_text.size()) : size;
    }

    std::string_view m_text;
    bool m_base64;
};

std::size_t headerNumber(std::string_view header, std::size_t at, const VtuEncoding& encoding) {
    const auto size = sizeOf(encoding.header);
    const auto value = decodeInteger(header.substr(at * size, size), encoding.header, encoding.order);
    if (value < 0 || value > (std::int64_t(1) << 48)) throw InputError("the data's header makes no sense");
    return static_cast<std::size_t>(value);
}

bool inflate(std::string_view packed, std::string& bytes) {
    uLongf written = bytes.size();
    const auto* source = reinterpret_cast<const Bytef*>(packed.data());
    return uncompress(reinterpret_cast<Bytef*>(bytes.data()), &written, source, packed.size()) == Z_OK &&
           written == bytes.size();
}

bool unpackLz4(std::string_view packed, std::string& bytes) {
    constexpr std::size_t most = LZ4_MAX_INPUT_SIZE;
    if (packed.size() > most || bytes.size() > most) return false;
    const int written = LZ4_decompress_safe(packed.data(), bytes.data(), static_cast<int>(packed.size()),
                                            static_cast<int>(bytes.size()));
    return written >= 0 && static_cast<std::size_t>(written) == bytes.size();
}

bool unpackLzma(std::string_view packed, std::string& bytes) {
    std::uint64_t memory = std::uint64_t(256) << 20;
    std::size_t read = 0, written = 0;
    const auto status = lzma_stream_buffer_decode(
        &memory, 0, nullptr, reinterpret_cast<const std::uint8_t*>(packed.data()), &read, packed.size(),
        reinterpret_cast<std::uint8_t*>(bytes.data()), &written, bytes.size());
    return status == LZMA_OK && written == bytes.size();
}

std::string unpacked(std::string_view packed, std::size_t size, VtuEncoding::Compressor compressor) {
    std::string bytes(size, '\0');
    const bool done = compressor == VtuEncoding::Compressor::Lz4    ? unpackLz4(packed, bytes)
                      : compressor == VtuEncoding::Compressor::Lzma ? unpackLzma(packed, bytes)
                                                                    : inflate(packed, bytes);
    if (!done) throw InputError("the compressed data is damaged");
    return bytes;
}

struct Block {
    std::size_t packed, size;  // in bytes
};

/// Returns the compressed blocks that follow the header, which is taken. All lengths are checked against what
/// the text can hold before anything is allocated for them.
std::vector<Block> takeBlocks(Pieces& pieces, std::size_t textSize, const VtuEncoding& encoding) {
    const auto word = sizeOf(encoding.header);
    const auto count = headerNumber(pieces.peek(word), 0, encoding);
    if (count > textSize) throw InputError("the data's header makes no sense");
    if (count == 0) return {};
    const auto header = pieces.take((3 + count) * word);
    const auto full = headerNumber(header, 1, encoding), partial = headerNumber(header, 2, encoding);
    std::vector<Block> blocks;
    std::size_t room = textSize;
    for (std::size_t b = 0; b < count; ++b) {
        const auto packed = headerNumber(header, 3 + b, encoding);
        const auto size = b + 1 == count && partial ? partial : full;
        if (packed > room) throw InputError("the data ends too early");
        if (size > maxRatio(encoding.compressor) * (packed + 1))
            throw InputError("the data's header makes no sense");
        blocks.push_back({packed, size});
        room -= packed;
    }
    return blocks;
}

std::size_t packedSize(const std::vector<Block>& blocks) {
    return std::accumulate(blocks.begin(), blocks.end(), std::size_t(0),
                           [](std::size_t sum, const Block& block) { return sum + block.packed; });
}

/// Decompresses all blocks, each of which must have exactly the stated length.
std::string decodeCompressed(Pieces pieces, std::size_t textSize, const VtuEncoding& encoding) {
    const std::vector<Block> blocks = takeBlocks(pieces, textSize, encoding);
    const std::string data = pieces.take(packedSize(blocks));
    std::string bytes;
    std::size_t at = 0;
    for (const auto& [packed, size] : blocks) {
        bytes += unpacked(std::string_view(data).substr(at, packed), size, encoding.compressor);
        at += packed;
    }
    return bytes;
}

std::string number(std::size_t value, const VtuEncoding& encoding) {
    std::string bytes;
    appendInteger(bytes, static_cast<std::int64_t>(value), encoding.header, encoding.order);
    return bytes;
}

std::string deflated(std::string_view bytes) {
    uLongf size = compressBound(bytes.size());
    std::string packed(size, '\0');
    const auto* source = reinterpret_cast<const Bytef*>(bytes.data());
    if (compress(reinterpret_cast<Bytef*>(packed.data()), &size, source, bytes.size()) != Z_OK)
        throw InputError("the data cannot be compressed");
    packed.resize(size);
    return packed;
}

}  // namespace

std::optional<Scalar> vtuScalarNamed(std::string_view name) {
    for (const auto& [known, type] : kScalars)
        if (known == name) return type;
    return std::nullopt;
}

std::string_view vtuScalarName(Scalar type) {
    return std::ranges::find(kScalars, type, &std::pair<std::string_view, Scalar>::second)->first;
}

std::size_t vtuArraySize(std::string_view text, const VtuEncoding& encoding) {
    Pieces pieces(text, encoding.base64);
    if (encoding.compressor == VtuEncoding::Compressor::None)
        return headerNumber(pieces.peek(sizeOf(encoding.header)), 0, encoding);
    std::size_t size = 0;
    for (const Block& block : takeBlocks(pieces, text.size(), encoding)) size += block.size;
    return size;
}

std::string decodeVtuArray(std::string_view text, const VtuEncoding& encoding) {
    Pieces pieces(text, encoding.base64);
    if (encoding.compressor != VtuEncoding::Compressor::None)
        return decodeCompressed(pieces, text.size(), encoding);
    const auto word = sizeOf(encoding.header);
    const auto size = headerNumber(pieces.peek(word), 0, encoding);
    if (pieces.closedAfter(word)) {  // used by some programs, but not by VTK
        pieces.take(word);
        return pieces.take(size);
    }
    return pieces.peek(word + std::min(size, text.size() + 1)).substr(word);
}

/// Encodes the bytes with a header, in one piece or, if compressed, in blocks.
std::string encodeVtuArray(std::string_view bytes, const VtuEncoding& encoding) {
    const auto wrapped = [&](std::string part) {
        return encoding.base64 ? encodeBase64(part) : std::move(part);
    };
    if (encoding.compressor == VtuEncoding::Compressor::None)
        return wrapped(number(bytes.size(), encoding) + std::string(bytes));
    std::vector<std::string> blocks;
    for (std::size_t at = 0; at < bytes.size(); at += blockSize)
        blocks.push_back(deflated(bytes.substr(at, blockSize)));
    std::string header = number(blocks.size(), encoding) + number(blockSize, encoding) +
                         number(bytes.size() % blockSize, encoding);
    std::string data;
    for (const auto& block : blocks) {
        header += number(block.size(), encoding);
        data += block;
    }
    return wrapped(std::move(header)) + wrapped(std::move(data));
}

}  // namespace wend::formats
