#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "warp/image.h"

namespace wend {

/// The pixels of a layer or mask as a Krita file has them: tiles, each packed by LZF with its bytes sorted by
/// their place in a pixel, and one pixel for all others.
class KritaPixels {
  public:
    /// Goes through the tiles without unpacking them. Throws InputError without a file.
    KritaPixels(std::string bytes, std::string other);

    /// Returns the box of the tiles; without any it is empty.
    const PixelBox& box() const { return m_box; }
    std::size_t pixelBytes() const { return m_pixelBytes; }
    /// Returns the pixel that is everywhere else.
    const std::string& other() const { return m_other; }
    /// Returns the rows of a box. Throws InputError without a file.
    std::string rows(const PixelBox& box) const;

  private:
    struct Tile {
        int x, y;
        std::size_t begin, size;  // of its bytes
    };
    void takeTile(std::size_t& at, std::string_view line);
    void addToBox(const Tile& tile);
    std::string unpacked(const Tile& tile) const;
    std::size_t tileBytes() const;

    std::string m_bytes, m_other;
    int m_width = 0, m_height = 0;  // of a tile
    std::size_t m_pixelBytes = 0;
    std::vector<Tile> m_tiles;
    PixelBox m_box;
};

/// Unpacks bytes by LZF: a number n < 32 before n + 1 bytes, or a length of three bits (with another byte if
/// all are set) and a distance of 13 bits to bytes that are there already. Throws InputError without a file
/// unless they are that many.
std::string fromLzf(std::string_view packed, std::size_t size);

}  // namespace wend
