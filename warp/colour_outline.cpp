#include "warp/colour_outline.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/meshing/outline_simplify.h"
#include "warp/convert.h"
#include "warp/outline_contour.h"
#include "warp/pixels.h"

namespace wend {
namespace {

constexpr double kSimplify = 0.5;  // pixels
constexpr float kMinimum = 1e-3F;  // of full scale: how far inside and outside are apart at least

/// The differences of all pixels' colours from one of them.
class ColourDistances {
  public:
    ColourDistances(const Image& image, int x, int y) : m_width(image.width), m_channels(image.channels) {
        std::vector<float> row(static_cast<std::size_t>(image.width) * image.channels);
        loadRow(image, y, row.data());
        std::vector<float> own(row.begin() + static_cast<std::ptrdiff_t>(x) * m_channels,
                               row.begin() + static_cast<std::ptrdiff_t>(x + 1) * m_channels);
        weigh(image, own.data());
        m_distances.reserve(static_cast<std::size_t>(image.width) * image.height);
        for (int j = 0; j < image.height; ++j) {
            loadRow(image, j, row.data());
            for (int i = 0; i < image.width; ++i) {
                float* const pixel = row.data() + static_cast<std::ptrdiff_t>(i) * m_channels;
                weigh(image, pixel);
                float most = 0;
                for (int c = 0; c < m_channels; ++c) most = std::max(most, std::abs(pixel[c] - own[c]));
                m_distances.push_back(std::isnan(most) ? std::numeric_limits<float>::max() : most);
            }
        }
    }
    float at(int x, int y) const {
        return m_distances[static_cast<std::size_t>(y) * m_width + static_cast<std::size_t>(x)];
    }

  private:
    /// Colours of transparent pixels do not count.
    void weigh(const Image& image, float* pixel) const {
        if (!image.alpha || !image.unassociated) return;
        for (int c = 0; c + 1 < m_channels; ++c) pixel[c] *= std::clamp(pixel[m_channels - 1], 0.0F, 1.0F);
    }

    int m_width, m_channels;
    std::vector<float> m_distances;
};

/// Returns the 4-connected component of the first pixel.
std::vector<bool> connected(const ColourDistances& distances, int width, int height, int x, int y,
                            float tolerance) {
    std::vector<bool> reached(static_cast<std::size_t>(width) * height);
    std::vector<std::pair<int, int>> front{{x, y}};
    reached[static_cast<std::size_t>(y) * width + x] = true;
    while (!front.empty()) {
        const auto [i, j] = front.back();
        front.pop_back();
        for (const auto& [a, b] : {std::pair{i - 1, j}, {i + 1, j}, {i, j - 1}, {i, j + 1}}) {
            if (a < 0 || b < 0 || a >= width || b >= height || !(distances.at(a, b) <= tolerance)) continue;
            const std::size_t at = static_cast<std::size_t>(b) * width + a;
            if (!reached[at]) front.emplace_back(a, b);
            reached[at] = true;
        }
    }
    return reached;
}

}  // namespace

Outline outlineOfColour(const Image& image, const Vec2& place, double tolerance) {
    const int x = static_cast<int>(std::floor(place.x())), y = static_cast<int>(std::floor(place.y()));
    if (x < 0 || y < 0 || x >= image.width || y >= image.height) return {};
    const auto allowed = static_cast<float>(tolerance);
    const ColourDistances distances(image, x, y);
    const auto inside = connected(distances, image.width, image.height, x, y, allowed);
    const ContourGrid grid{image.width, image.height};
    const auto value = [&](int i, int j) {
        const float by = allowed - distances.at(i, j);
        return inside[static_cast<std::size_t>(j) * image.width + i] ? std::max(by, kMinimum)
                                                                     : std::min(by, -kMinimum);
    };
    auto loops = zeroContours(grid, [&](int row, auto& values) {
        const int j = ContourGrid::pixel(row, image.height);
        for (int column = 1; column <= image.width + 2; ++column)
            values[static_cast<std::size_t>(column)] = value(ContourGrid::pixel(column, image.width), j);
    });
    return simplified({std::move(loops)}, kSimplify);
}

}  // namespace wend
