#include "app/window/notices/picture_checks.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "core/base/error.h"
#include "core/mesh/segments.h"
#include "warp/convert.h"
#include "warp/outline.h"

namespace wend {

namespace {

// --- Soft edges ---

constexpr float kLeastMissed = 0.02F;  // less is not missed
constexpr double kMuch = 0.01;         // of the pixels within

enum Pixel : std::uint8_t { Nothing, Faint, Within };

class PixelKinds {
  public:
    PixelKinds(const Image& picture, double threshold)
        : m_width(picture.width),
          m_height(picture.height),
          m_kinds(static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height)) {
        const auto channels = static_cast<std::size_t>(picture.channels);
        std::vector<float> row(static_cast<std::size_t>(m_width) * channels);
        std::size_t at = 0;
        for (int y = 0; y < m_height; ++y) {
            loadRow(picture, y, row.data());
            for (std::size_t i = channels - 1; i < row.size(); i += channels)
                m_kinds[at++] = row[i] >= static_cast<float>(threshold) ? Within
                                : row[i] > kLeastMissed                 ? Faint
                                                                        : Nothing;
        }
    }
    std::size_t count(Pixel kind) const {
        return static_cast<std::size_t>(std::ranges::count(m_kinds, kind));
    }
    /// Counts faint pixels farther than `reach` pixels from the outline.
    std::size_t countFar(int reach) const {
        std::size_t count = 0;
        for (int y = 0; y < m_height; ++y)
            for (int x = 0; x < m_width; ++x) count += at(x, y) == Faint && isFar(x, y, reach);
        return count;
    }

  private:
    Pixel at(int x, int y) const {
        return static_cast<Pixel>(m_kinds[static_cast<std::size_t>(y) * static_cast<std::size_t>(m_width) +
                                          static_cast<std::size_t>(x)]);
    }
    bool isFar(int x, int y, int reach) const {
        for (int v = std::max(0, y - reach); v <= std::min(m_height - 1, y + reach); ++v)
            for (int u = std::max(0, x - reach); u <= std::min(m_width - 1, x + reach); ++u)
                if (at(u, v) == Within) return false;
        return true;
    }

    int m_width, m_height;
    std::vector<std::uint8_t> m_kinds;
};

// --- Line art ---

constexpr double kMostInk = 0.4;    // of what the strokes enclose
constexpr double kThickest = 0.04;  // of the picture's diagonal: the mean width of a stroke

struct InkMeasure {
    double area = 0, length = 0;
};

/// Measures with the even-odd rule: holes count against what they are in.
InkMeasure measured(const Outline& outline) {
    InkMeasure sum;
    for (const auto& loop : outline.loops) {
        sum.area += loopArea(loop);
        for (std::size_t k = 0; k < loop.size(); ++k)
            sum.length += (loop[(k + 1) % loop.size()] - loop[k]).norm();
    }
    sum.area = std::abs(sum.area);
    return sum;
}

}  // namespace

bool hasOpaqueEdges(const Image& picture) {
    constexpr float kFull = 0.99F;
    if (!picture.alpha) return true;
    const auto channels = static_cast<std::size_t>(picture.channels);
    std::vector<float> row(static_cast<std::size_t>(picture.width) * channels);
    for (const int y : {0, picture.height - 1}) {
        loadRow(picture, y, row.data());
        for (std::size_t i = channels - 1; i < row.size(); i += channels)
            if (row[i] < kFull) return false;
    }
    return true;
}

bool cutsSoftEdges(const Image& picture, const AlphaOutlineOptions& outline) {
    if (!picture.alpha) return false;
    const PixelKinds pixels(picture, outline.threshold);
    const double much = kMuch * static_cast<double>(pixels.count(Within));
    if (static_cast<double>(pixels.count(Faint)) <= much) return false;
    return static_cast<double>(pixels.countFar(static_cast<int>(std::ceil(outline.margin)))) > much;
}

bool isLineArt(const Image& picture, const AlphaOutlineOptions& outline) {
    if (!picture.alpha) return false;
    try {
        AlphaOutlineOptions strokes = outline;
        strokes.margin = 0;
        strokes.holes = OutlineHoles::Kept;
        const InkMeasure ink = measured(outlineFromAlpha(picture, strokes));
        strokes.holes = OutlineHoles::Filled;
        const InkMeasure whole = measured(outlineFromAlpha(picture, strokes));
        const double width = ink.length > 0 ? 2 * ink.area / ink.length : 0;
        return ink.area < kMostInk * whole.area &&
               width < kThickest * std::hypot(picture.width, picture.height);
    } catch (const InputError&) {
        return false;
    }
}

}  // namespace wend
