#pragma once

#include <optional>
#include <string>

namespace wend {

/// Returns 0xRRGGBB for a text like "#d9822b"; nothing for any other text.
std::optional<unsigned> rgbOf(const std::string& text);

}  // namespace wend
