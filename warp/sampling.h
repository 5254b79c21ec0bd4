#pragma once

#include "core/base/types.h"

namespace wend {

enum class Filter { Nearest, Bilinear, Bicubic, Ewa };
enum class Outside { Transparent, Clamp, Colour, Original };

/// An axis-aligned window onto the warped plane: pixel (i, j) of the output has its centre at
/// origin + ((i + 0.5) · scale, (j + 0.5) · scale) in the picture's coordinates.
struct View {
    int width = 0, height = 0;
    Vec2 origin = Vec2::Zero();
    double scale = 1;
};

}  // namespace wend
