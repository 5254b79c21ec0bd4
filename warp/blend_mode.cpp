#include "warp/blend_mode.h"

#include <array>
#include <utility>

namespace wend {
namespace {

constexpr std::array kWords{
    std::pair{"normal", BlendMode::Normal}, std::pair{"multiply", BlendMode::Multiply},
    std::pair{"screen", BlendMode::Screen}, std::pair{"add", BlendMode::Add},
    std::pair{"", BlendMode::Normal},       std::pair{"src-over", BlendMode::Normal},
    std::pair{"plus", BlendMode::Add},      std::pair{"linear_dodge", BlendMode::Add},
};

}  // namespace

std::string_view blendWord(BlendMode mode) {
    return std::ranges::find(kWords, mode, &std::pair<const char*, BlendMode>::second)->first;
}

std::optional<BlendMode> blendNamed(std::string_view word) {
    for (const auto& [known, mode] : kWords)
        if (word == known) return mode;
    return std::nullopt;
}

}  // namespace wend
