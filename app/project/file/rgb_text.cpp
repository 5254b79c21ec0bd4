#include "app/project/file/rgb_text.h"

namespace wend {

std::optional<unsigned> rgbOf(const std::string& text) {
    const bool isColour = text.size() == 7 && text[0] == '#' &&
                          text.find_first_not_of("0123456789abcdefABCDEF", 1) == std::string::npos;
    if (!isColour) return {};
    return static_cast<unsigned>(std::stoul(text.substr(1), nullptr, 16));
}

}  // namespace wend
