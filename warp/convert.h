#pragma once

#include "warp/image.h"

namespace wend {

/// The storage of pixels.
struct PixelLayout {
    PixelType type = PixelType::UInt8;
    int channels = 4;
    bool alpha = true;
    bool unassociated = false;

    bool operator==(const PixelLayout&) const = default;
};

PixelLayout layoutOf(const Image& image);

/// Loads row y as floats, integers scaled to [0, 1]: width · channels values. storeRow gives back the same
/// bits.
void loadRow(const Image& image, int y, float* out);

/// Does the opposite of loadRow(): integers are clamped and rounded to the nearest.
void storeRow(Image& image, int y, const float* in);

/// Returns the picture in another layout; unchanged if it already has it. Grey becomes equal colours; surplus
/// colours are dropped; without alpha the picture is placed on white; a new alpha is opaque.
Image converted(const Image& image, const PixelLayout& layout);

}  // namespace wend
