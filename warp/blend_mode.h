#pragma once

#include <algorithm>
#include <optional>
#include <string_view>

namespace wend {

/// How a sheet is combined with what is below it. Outside of that, and where it is transparent, all are the
/// same.
enum class BlendMode { Normal, Multiply, Screen, Add };

/// Returns the word of project files: "normal", "multiply", "screen" or "add".
std::string_view blendWord(BlendMode mode);

/// Returns the mode for the word of a project file, or of a file with layers: "svg:plus" without its prefix,
/// Krita's "linear_dodge". An empty one is normal. Returns nothing for other modes.
std::optional<BlendMode> blendNamed(std::string_view word);

/// Returns a colour over another: cs (1 − αb) + cb (1 − αs) + αs αb B(cb / αb, cs / αs), both associated with
/// their alphas, in [0, 1]. Sums of light may be brighter than white.
/// The formula: https://www.w3.org/TR/compositing-1/#generalformula
template <typename Number>
Number blendedColour(BlendMode mode, Number top, Number topAlpha, Number below, Number belowAlpha,
                     bool isLight) {
    const Number apart = top * (1 - belowAlpha) + below * (1 - topAlpha);
    switch (mode) {
        case BlendMode::Multiply:
            return apart + top * below;
        case BlendMode::Screen:
            return top + below - top * below;
        case BlendMode::Add: {
            const Number sum = top * belowAlpha + below * topAlpha;
            return apart + (isLight ? sum : std::min(topAlpha * belowAlpha, sum));
        }
        case BlendMode::Normal:
            break;
    }
    return top + below * (1 - topAlpha);
}

}  // namespace wend
