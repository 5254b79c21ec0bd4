#pragma once

#include <vector>

#include "warp/image.h"

namespace wend {

/// A picture as two that are over one another.
struct Matte {
    Image top, ground;
};

/// Separates what is in front of a ground: share[i] in [0, 1] is how much of pixel i the top takes. Over one
/// another both give the picture again: C = T + (1 − t) G in associated form, with t the alpha of T. Where
/// the share is below 1, the ground's colours are removed from those of the top. Since these must be neither
/// below zero nor above white, t exceeds share · α by as much as that requires, up to twice the share, so
/// that an edge is also soft where it crosses the object in front; the remainder stays in the ground. Where
/// the picture is not opaque, the alpha of the ground is at most what T leaves of the picture's. Without a
/// share the pixel is all ground. All pictures have the same size, floats, alpha and associated colours.
Matte separated(const Image& picture, const Image& ground, const std::vector<float>& share);

}  // namespace wend
