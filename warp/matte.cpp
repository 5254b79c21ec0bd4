#include "warp/matte.h"

#include <algorithm>

namespace wend {
namespace {

constexpr float kSoonest = 2;  // of the share: alpha grows no faster at the edge of a cut

/// Returns the least alpha at which a channel of the top, (c − (1 − t) g), is neither negative nor above t ·
/// white.
float leastAlpha(float c, float g) {
    const float white = std::max({1.0F, c, g});
    float least = 0;
    if (c < g) least = (g - c) / g;
    if (c > g && white > g) least = (c - g) / (white - g);
    return least;
}

/// Removes an opaque ground's colours from a pixel, in whose place the top has alpha t. What would not be a
/// colour of the top stays in the ground.
void separateColours(const float* picture, std::size_t colours, float t, float* ground, float* top) {
    float white = 1;
    for (std::size_t c = 0; c < colours; ++c) white = std::max({white, picture[c], ground[c]});
    for (std::size_t c = 0; c < colours; ++c) {
        top[c] = std::clamp(picture[c] - (1 - t) * ground[c], 0.0F, t * white);
        if (t < 1) ground[c] = (picture[c] - top[c]) / (1 - t);
    }
    top[colours] = t;
}

/// Separates one pixel with its alpha last. The ground becomes transparent where the picture is not opaque.
void separatePixel(const float* picture, std::size_t colours, float share, float* ground, float* top) {
    const float alpha = picture[colours];
    float t = share * alpha;
    const float left = t < 1 ? (alpha - t) / (1 - t) : 1;
    if (ground[colours] > left) {
        const float by = left / ground[colours];
        for (std::size_t c = 0; c <= colours; ++c) ground[c] *= by;
    }
    const float g = ground[colours];
    if (g < 1) t = std::max(t, (alpha - g) / (1 - g));
    if (g == 1) {
        float least = 0;
        for (std::size_t c = 0; c < colours; ++c) least = std::max(least, leastAlpha(picture[c], ground[c]));
        return separateColours(picture, colours, std::max(t, std::min(least, kSoonest * share)), ground, top);
    }
    t = std::min(t, 1.0F);
    for (std::size_t c = 0; c < colours; ++c) top[c] = std::max(0.0F, picture[c] - (1 - t) * ground[c]);
    top[colours] = t;
}

}  // namespace

Matte separated(const Image& picture, const Image& ground, const std::vector<float>& share) {
    Matte matte{picture, ground};
    const auto channels = static_cast<std::size_t>(picture.channels);
    for (std::size_t i = 0; i < share.size(); ++i) {
        const float* from = reinterpret_cast<const float*>(picture.data.data()) + i * channels;
        float* top = reinterpret_cast<float*>(matte.top.data.data()) + i * channels;
        float* below = reinterpret_cast<float*>(matte.ground.data.data()) + i * channels;
        if (share[i] > 0) {
            separatePixel(from, channels - 1, share[i], below, top);
        } else {
            std::fill_n(top, channels, 0.0F);
            std::copy_n(from, channels, below);
        }
    }
    return matte;
}

}  // namespace wend
