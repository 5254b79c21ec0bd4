#pragma once

#include <optional>
#include <string>

namespace wend {

/// Whole pixels of a picture, from its upper left corner; it may reach beyond the picture.
struct PixelRect {
    int x = 0, y = 0, width = 1, height = 1;
    bool operator==(const PixelRect&) const = default;
};

/// "X,Y,WIDTH,HEIGHT" as on the command line; nothing for any other text, without pixels, and where a number
/// has more than six digits.
std::optional<PixelRect> pixelRectOf(const std::string& text);
std::string textOf(const PixelRect& rectangle);

}  // namespace wend
