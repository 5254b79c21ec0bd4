#include "warp/outline.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>

#include "core/base/error.h"
#include "core/mesh/segments.h"
#include "core/meshing/outline_simplify.h"
#include "warp/outline_contour.h"
#include "warp/outline_growth.h"
#include "warp/pixels.h"

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

/// Returns a number of a pixel, with full = 1.
float sample(PixelType type, const std::byte* at) {
    return withPixelType(type, [at](auto kind) {
        decltype(kind) value;
        std::memcpy(&value, at, sizeof value);
        return static_cast<float>(value) / kFull<decltype(kind)>;
    });
}

/// Alpha minus threshold in a row of the contour's nodes. NaN counts as transparent.
class AlphaRows {
  public:
    AlphaRows(const Image& image, double threshold)
        : m_image(image),
          m_threshold(static_cast<float>(threshold)),
          m_bytes(image.pixelBytes() / image.channels) {}

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
    /// Returns whether no alpha was above 0.
    bool empty() const { return m_empty; }

  private:
    const Image& m_image;
    float m_threshold;
    std::size_t m_bytes;
    bool m_empty = true;
};

void requireAlpha(const Image& image) {
    if (!image.alpha || image.channels < 1)
        throw InputError(sentence("Core", "the picture has no alpha channel to take an outline from"));
    const auto pixels = static_cast<std::size_t>(std::max(image.width, 0)) * std::max(image.height, 0);
    if (pixels == 0 || image.data.size() < pixels * image.pixelBytes())
        throw InputError(sentence("Core", "the picture has no pixels"));
}

std::vector<std::vector<Vec2>> withoutSpecks(std::vector<std::vector<Vec2>> loops, double smallest) {
    // Loops inside a dropped one are smaller and are dropped, too.
    const auto isSpeck = [&](const auto& loop) { return std::abs(loopArea(loop)) < smallest; };
    loops.erase(std::remove_if(loops.begin(), loops.end(), isSpeck), loops.end());
    if (loops.empty())
        throw InputError(
            {sentence("Core", "no part of the picture is as large as %1 pixels"), std::lround(smallest)});
    return loops;
}

std::vector<std::vector<Vec2>> alphaContours(const Image& image, const ContourGrid& grid, double threshold) {
    AlphaRows rows(image, threshold);
    auto loops = zeroContours(grid, [&](int row, auto& values) { rows.fillRow(row, values); });
    if (!loops.empty()) return loops;
    if (rows.empty()) throw InputError(sentence("Core", "the picture is fully transparent"));
    throw InputError({sentence("Core", "the picture's alpha is nowhere above the threshold of %1 %"),
                      std::lround(100 * threshold)});
}

bool isInside(const Vec2& p, const std::vector<Vec2>& loop) {
    bool inside = false;
    for (std::size_t i = 0; i < loop.size(); ++i)
        if (crossesRay(loop[i], loop[(i + 1) % loop.size()], p)) inside = !inside;
    return inside;
}

/// Returns the loops that are inside no other one. Loops do not cross, so that one point of each decides.
std::vector<std::vector<Vec2>> outermost(std::vector<std::vector<Vec2>> loops) {
    std::ranges::stable_sort(loops, std::greater(),
                             [](const auto& loop) { return std::abs(loopArea(loop)); });
    std::vector<std::vector<Vec2>> outer;
    std::vector<Eigen::AlignedBox2d> boxes;
    for (auto& loop : loops) {
        bool within = false;
        for (std::size_t k = 0; k < outer.size() && !within; ++k)
            within = boxes[k].contains(loop[0]) && isInside(loop[0], outer[k]);
        if (within) continue;
        Eigen::AlignedBox2d& box = boxes.emplace_back();
        for (const Vec2& p : loop) box.extend(p);
        outer.push_back(std::move(loop));
    }
    return outer;
}

}  // namespace

Outline outlineFromAlpha(const Image& image, const AlphaOutlineOptions& options) {
    requireOptions(options);
    requireAlpha(image);
    const ContourGrid grid{image.width, image.height};
    const auto asAsked = [&](auto loops) {
        loops = withoutSpecks(std::move(loops), options.smallest);
        return options.holes == OutlineHoles::Filled ? outermost(std::move(loops)) : loops;
    };
    auto loops = asAsked(alphaContours(image, grid, options.threshold));
    if (options.margin > 0) {
        GrownShape grown(grid, loops, options.margin, options.gap);
        loops = asAsked(zeroContours(grid, [&](int row, auto& values) { grown.fillRow(row, values); }));
    }
    return simplified({std::move(loops)}, options.simplify);
}

Outline frameOutline(int width, int height) {
    if (width <= 0 || height <= 0) throw InputError(sentence("Core", "the picture has no pixels"));
    const double w = width, h = height;
    return {{{{0, 0}, {w, 0}, {w, h}, {0, h}}}};
}

}  // namespace wend
