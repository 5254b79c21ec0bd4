#include "warp/outline.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "core/mesh/error.h"
#include "core/meshing/outline_simplify.h"
#include "warp/outline_contour.h"
#include "warp/outline_growth.h"

namespace wend {
namespace {

void requireOptions(const AlphaOutlineOptions& o) {
    if (!(o.threshold > 0 && o.threshold < 1))
        throw InputError("the alpha threshold must be between 0 and 1");
    if (!(o.margin >= 0 && o.margin <= 100)) throw InputError("the outline's margin must be 0 … 100 pixels");
    if (!(o.gap >= 0 && o.gap <= 100)) throw InputError("the outline's gap must be 0 … 100 pixels");
    if (!(o.smallest >= 0)) throw InputError("the smallest area of a part must not be negative");
    if (!(o.simplify >= 0 && o.simplify <= 1000))
        throw InputError("the outline's simplification must be 0 … 1000 pixels");
}

float fromHalf(std::uint16_t bits) {
    const int exponent = (bits >> 10) & 31, mantissa = bits & 1023;
    float value = std::numeric_limits<float>::infinity();
    if (exponent == 0)
        value = std::ldexp(static_cast<float>(mantissa), -24);
    else if (exponent < 31)
        value = std::ldexp(static_cast<float>(mantissa + 1024), exponent - 25);
    else if (mantissa != 0)
        return std::numeric_limits<float>::quiet_NaN();
    return (bits & 0x8000) != 0 ? -value : value;
}

template <typename T>
T load(const std::byte* at) {
    T value;
    std::memcpy(&value, at, sizeof value);
    return value;
}

std::size_t sampleBytes(PixelType type) {
    switch (type) {
        case PixelType::UInt8:
            return 1;
        case PixelType::UInt16:
        case PixelType::Half:
            return 2;
        case PixelType::Float:
            return 4;
    }
    return 0;
}

float sample(PixelType type, const std::byte* at) {
    switch (type) {
        case PixelType::UInt8:
            return load<std::uint8_t>(at) / 255.0F;
        case PixelType::UInt16:
            return load<std::uint16_t>(at) / 65535.0F;
        case PixelType::Half:
            return fromHalf(load<std::uint16_t>(at));
        case PixelType::Float:
            return load<float>(at);
    }
    return 0;
}

/// Alpha minus threshold at a row of the contour's nodes. What is not a number counts as transparent.
class AlphaRows {
  public:
    AlphaRows(const Image& image, double threshold)
        : m_image(image), m_threshold(static_cast<float>(threshold)), m_bytes(sampleBytes(image.type)) {}

    void fillRow(int row, std::vector<float>& values) {
        const std::size_t stride = m_bytes * m_image.channels;
        const std::byte* at = m_image.data.data() +
                              stride * m_image.width * ContourGrid::pixel(row, m_image.height) + stride -
                              m_bytes;
        for (int x = 0; x < m_image.width; ++x, at += stride) {
            const float alpha = std::min(sample(m_image.type, at), 2.0F);
            values[x + 2] = alpha > m_threshold ? alpha - m_threshold : std::min(alpha - m_threshold, 0.0F);
            if (std::isnan(alpha)) values[x + 2] = -m_threshold;
            if (alpha > 0) m_empty = false;
        }
        values[1] = values[2];
        values[m_image.width + 2] = values[m_image.width + 1];
    }
    /// No alpha above 0 was met.
    bool empty() const { return m_empty; }

  private:
    const Image& m_image;
    float m_threshold;
    std::size_t m_bytes;
    bool m_empty = true;
};

void requireAlpha(const Image& image) {
    if (!image.alpha || image.channels < 1)
        throw InputError("the picture has no alpha channel to take an outline from");
    const auto pixels = static_cast<std::size_t>(std::max(image.width, 0)) * std::max(image.height, 0);
    if (pixels == 0 || image.data.size() < pixels * image.channels * sampleBytes(image.type))
        throw InputError("the picture has no pixels");
}

std::vector<std::vector<Vec<2>>> withoutSpecks(std::vector<std::vector<Vec<2>>> loops, double smallest) {
    // A loop within a dropped one is smaller still and goes with it.
    const auto isSpeck = [&](const auto& loop) { return std::abs(loopArea(loop)) < smallest; };
    loops.erase(std::remove_if(loops.begin(), loops.end(), isSpeck), loops.end());
    if (loops.empty())
        throw InputError("no part of the picture is as large as " + std::to_string(std::lround(smallest)) +
                         " pixels");
    return loops;
}

std::vector<std::vector<Vec<2>>> alphaContours(const Image& image, const ContourGrid& grid,
                                               double threshold) {
    AlphaRows rows(image, threshold);
    auto loops = zeroContours(grid, [&](int row, auto& values) { rows.fillRow(row, values); });
    if (!loops.empty()) return loops;
    if (rows.empty()) throw InputError("the picture is fully transparent");
    throw InputError("the picture's alpha is nowhere above the threshold of " +
                     std::to_string(std::lround(100 * threshold)) + " %");
}

}  // namespace

Outline outlineFromAlpha(const Image& image, const AlphaOutlineOptions& options) {
    requireOptions(options);
    requireAlpha(image);
    const ContourGrid grid{image.width, image.height};
    auto loops = withoutSpecks(alphaContours(image, grid, options.threshold), options.smallest);
    if (options.margin > 0) {
        GrownShape grown(grid, loops, options.margin, options.gap);
        loops = withoutSpecks(zeroContours(grid, [&](int row, auto& values) { grown.fillRow(row, values); }),
                              options.smallest);
    }
    return simplified({std::move(loops)}, options.simplify);
}

Outline frameOutline(int width, int height) {
    if (width <= 0 || height <= 0) throw InputError("the picture has no pixels");
    const double w = width, h = height;
    return {{{{0, 0}, {w, 0}, {w, h}, {0, h}}}};
}

}  // namespace wend
