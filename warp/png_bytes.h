#pragma once

#include <string>

namespace wend {

/// Pixels as a PNG file has them: rows from top to bottom, channels interleaved, numbers of 16 bits with the
/// most significant byte first, alpha last and not multiplied with the colours.
struct PngPixels {
    int width = 0, height = 0, bits = 8;
    int colours = 3;  // 1: grey
    bool alpha = false;
    std::string rows;

    std::size_t pixelBytes() const {
        return static_cast<std::size_t>(bits / 8) * static_cast<std::size_t>(colours + (alpha ? 1 : 0));
    }
    std::size_t rowBytes() const { return pixelBytes() * static_cast<std::size_t>(width); }
};

/// Returns a PNG file of them, with this colour profile if it is not empty.
std::string pngBytes(const PngPixels& pixels, const std::string& profile);

}  // namespace wend
