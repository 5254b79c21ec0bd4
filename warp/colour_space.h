#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace wend {

/// A colour space as files name it that carry no ICC profile: by chromaticities and a curve.
struct ColourSpace {
    /// How a value in [0, 1] becomes light. Power: light = value^gamma.
    enum class Curve { Power, Srgb, Bt709, Pq, Hlg };
    using Chromaticities = std::array<double, 8>;  // CIE 1931 x, y of red, green, blue, white

    static constexpr Chromaticities kBt709 = {0.64, 0.33, 0.30, 0.60, 0.15, 0.06, 0.3127, 0.3290};

    Chromaticities chromaticities = kBt709;
    Curve curve = Curve::Srgb;
    double gamma = 1;
    std::string name;  // for people; may be empty

    /// Returns whether the chromaticities are BT.709's (and sRGB's), as far as the formats round them.
    bool hasCommonColours() const;
};

/// Returns an ICC profile, version 4, of a matrix and a curve: colorants adapted to D50 by Bradford's
/// transform (ICC.1:2022, annexes E and F); for `grey` the curve alone. Empty if the chromaticities span no
/// colours.
std::vector<std::byte> iccProfileOf(const ColourSpace& space, bool grey);

/// Does the same with the colorants of BT.709 and a curve given as the data of an ICC tag.
std::vector<std::byte> colouredProfileOf(std::string_view curve);

}  // namespace wend
