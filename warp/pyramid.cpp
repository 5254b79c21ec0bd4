#include "warp/pyramid.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <type_traits>

#include "warp/pixels.h"

namespace wend {
namespace {

template <typename T>
bool isFinite(const T* pixel, int channels) {
    return std::all_of(pixel, pixel + channels,
                       [](T value) { return std::isfinite(static_cast<float>(value)); });
}

/// Moves the pixels whose numbers are all finite to the front and returns how many those are, or all if there
/// are none.
template <typename T>
int finiteFirst(std::array<const T*, 4>& pixels, int channels) {
    if constexpr (std::is_integral_v<T>) return 4;
    const auto end = std::stable_partition(pixels.begin(), pixels.end(),
                                           [&](const T* pixel) { return isFinite(pixel, channels); });
    return end == pixels.begin() ? 4 : static_cast<int>(end - pixels.begin());
}

/// Averages four pixels without those that are not finite; colours that are not associated are weighted with
/// alpha.
template <typename T>
void average(std::array<const T*, 4> pixels, const Image& image, T* target) {
    const int channels = image.channels, count = finiteFirst(pixels, channels);
    float weight = 0;
    std::array<float, 4> sum{}, plain{};
    for (int k = 0; k < count; ++k) {
        const float w = image.unassociated ? static_cast<float>(pixels[k][channels - 1]) : 1.0F;
        weight += w;
        for (int c = 0; c < channels; ++c) {
            sum[c] += w * static_cast<float>(pixels[k][c]);
            plain[c] += static_cast<float>(pixels[k][c]) / static_cast<float>(count);
        }
    }
    const bool weighted = weight > 0;
    for (int c = 0; c < channels; ++c) target[c] = toPixel<T>(weighted ? sum[c] / weight : plain[c]);
    if (image.alpha) target[channels - 1] = toPixel<T>(plain[channels - 1]);
}

template <typename T>
void halve(const Image& image, Image& half) {
    for (int y = 0; y < half.height; ++y) {
        T* target = reinterpret_cast<T*>(half.row(y));
        const int y0 = 2 * y, y1 = std::min(2 * y + 1, image.height - 1);
        const T* rows[2] = {reinterpret_cast<const T*>(image.row(y0)),
                            reinterpret_cast<const T*>(image.row(y1))};
        for (int x = 0; x < half.width; ++x) {
            const int x0 = 2 * x * image.channels, x1 = std::min(2 * x + 1, image.width - 1) * image.channels;
            average<T>({rows[0] + x0, rows[0] + x1, rows[1] + x0, rows[1] + x1}, image,
                       target + x * image.channels);
        }
    }
}

std::shared_ptr<const Image> halved(const Image& image) {
    auto half = std::make_shared<Image>(Image{(image.width + 1) / 2,
                                              (image.height + 1) / 2,
                                              image.channels,
                                              image.type,
                                              image.alpha,
                                              image.unassociated,
                                              {},
                                              image.metadata});
    half->makePixels();
    withPixelType(image.type, [&](auto t) { halve<decltype(t)>(image, *half); });
    return half;
}

bool isOpaque(const Image& image) {
    if (!image.alpha) return true;
    const std::size_t count = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    return withPixelType(image.type, [&](auto t) {
        using T = decltype(t);
        const T* alpha = reinterpret_cast<const T*>(image.data.data()) + image.channels - 1;
        for (std::size_t p = 0; p < count; ++p, alpha += image.channels)
            if (static_cast<float>(*alpha) < kFull<T>) return false;
        return true;
    });
}

}  // namespace

Pyramid::Pyramid(std::shared_ptr<const Image> image, int levels) : m_opaque(isOpaque(*image)) {
    m_levels.push_back(std::move(image));
    while ((levels < 0 || this->levels() <= levels) &&
           (m_levels.back()->width > 1 || m_levels.back()->height > 1))
        m_levels.push_back(halved(*m_levels.back()));
}

int Pyramid::levelsOf(int width, int height) {
    return static_cast<int>(std::bit_width(static_cast<unsigned>(std::max(width, height) - 1))) + 1;
}

}  // namespace wend
