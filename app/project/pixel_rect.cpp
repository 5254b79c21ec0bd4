#include "app/project/pixel_rect.h"

#include <regex>

namespace wend {

std::optional<PixelRect> pixelRectOf(const std::string& text) {
    static const std::regex form("(-?[0-9]{1,6}),(-?[0-9]{1,6}),([0-9]{1,6}),([0-9]{1,6})");
    std::smatch parts;
    if (!std::regex_match(text, parts, form)) return {};
    const PixelRect rectangle{std::stoi(parts[1]), std::stoi(parts[2]), std::stoi(parts[3]),
                              std::stoi(parts[4])};
    return rectangle.width > 0 && rectangle.height > 0 ? std::optional(rectangle) : std::nullopt;
}

std::string textOf(const PixelRect& rectangle) {
    return std::to_string(rectangle.x) + ',' + std::to_string(rectangle.y) + ',' +
           std::to_string(rectangle.width) + ',' + std::to_string(rectangle.height);
}

}  // namespace wend
