#pragma once

#include <vector>

#include "warp/image.h"

namespace wend {

/// A picture as two that lie over one another.
struct Matte {
    Image top, ground;
};

/// Separates what lies before a ground: share[i] in [0, 1] is how much of pixel i the top takes. Over one
/// another both are the picture again: C = T + (1 − t) G in associated form, t the alpha of T. Where the
/// share is below 1, the ground's colours are taken out of those of the top; as they may not be below zero or
/// above white, t is as much greater than share · α as that needs. Where the picture is not opaque, the
/// ground gives way: its alpha is at most what T leaves of the picture's. Without a share the pixel is all
/// ground. All pictures have the same size, floats, alpha and associated colours.
Matte separated(const Image& picture, const Image& ground, const std::vector<float>& share);

}  // namespace wend
