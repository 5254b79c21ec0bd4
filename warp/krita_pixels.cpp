#include "warp/krita_pixels.h"

#include <algorithm>
#include <charconv>

#include "core/base/error.h"

namespace wend {
namespace {

constexpr int kFarthest = 100'000'000, kLargestTile = 1024, kLargestPixel = 64;

[[noreturn]] void failDamaged() {
    throw InputError(sentence("Core", "is truncated or corrupt"));
}

/// Returns the line at a place, without its end, and moves the place behind it.
std::string_view nextLine(std::string_view bytes, std::size_t& at) {
    constexpr std::size_t kLongest = 100;
    const std::size_t end = bytes.substr(0, std::min(bytes.size(), at + kLongest)).find('\n', at);
    if (end == std::string_view::npos) failDamaged();
    const std::string_view line = bytes.substr(at, end - at);
    at = end + 1;
    return line;
}

int numberIn(std::string_view text, int lowest, int highest) {
    int value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || value < lowest || value > highest)
        failDamaged();
    return value;
}

/// Reads the number of a line "KEY number".
int numberOf(std::string_view line, std::string_view key, int lowest, int highest) {
    if (!line.starts_with(key) || line.size() <= key.size() || line[key.size()] != ' ') failDamaged();
    return numberIn(line.substr(key.size() + 1), lowest, highest);
}

std::string_view upTo(char end, std::string_view& text) {
    const std::size_t at = text.find(end);
    if (at == std::string_view::npos) failDamaged();
    const std::string_view before = text.substr(0, at);
    text.remove_prefix(at + 1);
    return before;
}

}  // namespace

std::string fromLzf(std::string_view packed, std::size_t size) {
    std::string bytes;
    bytes.reserve(size);
    std::size_t at = 0;
    const auto next = [&] {
        if (at == packed.size()) failDamaged();
        return static_cast<std::size_t>(static_cast<unsigned char>(packed[at++]));
    };
    while (at < packed.size()) {
        const std::size_t first = next();
        if (first < 32) {
            if (first + 1 > packed.size() - at) failDamaged();
            bytes += packed.substr(at, first + 1);
            at += first + 1;
        } else {
            std::size_t length = first >> 5U;
            if (length == 7) length += next();
            const std::size_t distance = ((first & 31U) << 8U) + next() + 1;
            if (distance > bytes.size()) failDamaged();
            for (std::size_t k = 0; k < length + 2; ++k) bytes += bytes[bytes.size() - distance];
        }
        if (bytes.size() > size) failDamaged();
    }
    if (bytes.size() != size) failDamaged();
    return bytes;
}

KritaPixels::KritaPixels(std::string bytes, std::string other)
    : m_bytes(std::move(bytes)), m_other(std::move(other)) {
    std::size_t at = 0;
    if (!m_bytes.starts_with("VERSION "))
        throw InputError("was saved by a very old Krita: save it again with a newer one");
    numberOf(nextLine(m_bytes, at), "VERSION", 2, 2);
    m_width = numberOf(nextLine(m_bytes, at), "TILEWIDTH", 1, kLargestTile);
    m_height = numberOf(nextLine(m_bytes, at), "TILEHEIGHT", 1, kLargestTile);
    m_pixelBytes = static_cast<std::size_t>(numberOf(nextLine(m_bytes, at), "PIXELSIZE", 1, kLargestPixel));
    m_other.resize(m_pixelBytes, '\0');
    for (int left = numberOf(nextLine(m_bytes, at), "DATA", 0, kFarthest); left > 0; --left)
        takeTile(at, nextLine(m_bytes, at));
}

/// Reads a tile, whose line is "X,Y,LZF,SIZE".
void KritaPixels::takeTile(std::size_t& at, std::string_view line) {
    Tile tile{};
    tile.x = numberIn(upTo(',', line), -kFarthest, kFarthest);
    tile.y = numberIn(upTo(',', line), -kFarthest, kFarthest);
    if (upTo(',', line) != "LZF") throw InputError("has a layer that is packed in a way that is not known");
    tile.size = static_cast<std::size_t>(numberIn(line, 1, kFarthest));
    tile.begin = at;
    if (tile.size > m_bytes.size() - at) failDamaged();
    at += tile.size;
    addToBox(tile);
    m_tiles.push_back(tile);
}

void KritaPixels::addToBox(const Tile& tile) {
    if (m_tiles.empty()) {
        m_box = {tile.x, tile.y, m_width, m_height};
        return;
    }
    const int right = std::max(m_box.x + m_box.width, tile.x + m_width);
    const int bottom = std::max(m_box.y + m_box.height, tile.y + m_height);
    m_box.x = std::min(m_box.x, tile.x), m_box.y = std::min(m_box.y, tile.y);
    m_box.width = right - m_box.x, m_box.height = bottom - m_box.y;
}

std::size_t KritaPixels::tileBytes() const {
    return static_cast<std::size_t>(m_width) * static_cast<std::size_t>(m_height) * m_pixelBytes;
}

/// Unpacks a tile. The first byte says whether the others are packed; if so, the first bytes of all pixels
/// come first.
std::string KritaPixels::unpacked(const Tile& tile) const {
    const std::string_view bytes = std::string_view(m_bytes).substr(tile.begin, tile.size);
    const std::string_view content = bytes.substr(1);
    if (bytes.front() == 0) {
        if (content.size() != tileBytes()) failDamaged();
        return std::string(content);
    }
    const std::string sorted = fromLzf(content, tileBytes());
    std::string pixels(tileBytes(), '\0');
    const std::size_t count = tileBytes() / m_pixelBytes;
    for (std::size_t p = 0; p < count; ++p)
        for (std::size_t k = 0; k < m_pixelBytes; ++k) pixels[p * m_pixelBytes + k] = sorted[k * count + p];
    return pixels;
}

std::string KritaPixels::rows(const PixelBox& box) const {
    const auto bytes = [&](int pixels) { return m_pixelBytes * static_cast<std::size_t>(pixels); };
    std::string rows;
    rows.reserve(bytes(box.width) * static_cast<std::size_t>(box.height));
    while (rows.size() < bytes(box.width) * static_cast<std::size_t>(box.height)) rows += m_other;
    for (const Tile& tile : m_tiles) {
        const int left = std::max(box.x, tile.x), right = std::min(box.x + box.width, tile.x + m_width);
        const int top = std::max(box.y, tile.y), bottom = std::min(box.y + box.height, tile.y + m_height);
        if (left >= right || top >= bottom) continue;
        const std::string pixels = unpacked(tile);
        for (int y = top; y < bottom; ++y)
            std::copy_n(
                pixels.begin() + static_cast<std::ptrdiff_t>(bytes((y - tile.y) * m_width + left - tile.x)),
                bytes(right - left),
                rows.begin() +
                    static_cast<std::ptrdiff_t>(bytes(box.width) * static_cast<std::size_t>(y - box.y) +
                                                bytes(left - box.x)));
    }
    return rows;
}

}  // namespace wend
