#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "core/mesh/simplicial_mesh.h"
#include "warp/coverage.h"

namespace wend {

/// The pixels on the outline of the shape, or of a part in front of what it is attached to, with the coverage
/// of triangles at 8 × 8 samples each.
class OutlinePixels {
  public:
    struct Pixel {
        int x, y, index;  // index: the place in the band's list
    };

    OutlinePixels() = default;
    /// Makes an empty set.
    OutlinePixels(int bands, int bandRows) : m_bandRows(bandRows), m_bands(static_cast<std::size_t>(bands)) {}
    /// `pixels` are the vertices in pixels of the output.
    OutlinePixels(const PaintingPlan& plan, const Points<2>& pixels, int width, int height, int bandRows);

    /// Returns the pixels by rows, then from left to right.
    const std::vector<Pixel>& pixels(int band) const {
        return m_bands[static_cast<std::size_t>(band)].pixels;
    }

    /// Calls found(index, samples) for all pixels of the band of which the triangle covers something; bit 8 j
    /// + i is the place ((i + ½) / 8, (j + ½) / 8) in the pixel.
    template <typename Found>
    void visit(int band, const TriangleRows& rows, Found&& found) const;

  private:
    static constexpr int kColumn = 16;
    struct Band {
        std::vector<Pixel> pixels;
        std::vector<int> rowStart;  // of every row, and the end
        std::vector<int> before;    // number of pixels left of every kColumn-th column, and of the end

        /// Returns whether there may be one between two columns: most cells are inside the shape, where there
        /// is none.
        bool hasAny(double left, double right) const {
            const auto last = static_cast<double>(before.size()) - 1;
            const auto from = static_cast<std::size_t>(std::clamp(std::floor(left / kColumn), 0.0, last)),
                       to = static_cast<std::size_t>(std::clamp(std::floor(right / kColumn) + 1, 0.0, last));
            return before[to] > before[from];
        }
    };
    /// Returns the samples that the spans of the pixel's eight rows of places cover.
    static std::uint64_t samplesOf(int x, const std::array<Span, 8>& spans);

    int m_bandRows = 1;
    std::vector<Band> m_bands;
};

template <typename Found>
void OutlinePixels::visit(int band, const TriangleRows& rows, Found&& found) const {
    const Band& own = m_bands[static_cast<std::size_t>(band)];
    const double left = std::floor(rows.left()), right = rows.right();
    if (own.pixels.empty() || !own.hasAny(left, right)) return;
    const int bandTop = band * m_bandRows, bandEnd = bandTop + m_bandRows;
    const int begin = static_cast<int>(std::max<double>(bandTop, std::floor(rows.top())));
    for (int y = begin; y < bandEnd && y < rows.bottom(); ++y) {
        const Pixel* it = own.pixels.data() + own.rowStart[static_cast<std::size_t>(y - bandTop)];
        const Pixel* end = own.pixels.data() + own.rowStart[static_cast<std::size_t>(y - bandTop) + 1];
        it = std::lower_bound(it, end, left, [](const Pixel& p, double x) { return p.x < x; });
        if (it == end || it->x >= right) continue;
        std::array<Span, 8> spans{};
        for (int j = 0; j < 8; ++j) {
            const double at = y + (j + 0.5) / 8;
            if (at >= rows.top() && at < rows.bottom()) spans[static_cast<std::size_t>(j)] = rows.at(at);
        }
        for (; it != end && it->x < right; ++it)
            if (const std::uint64_t samples = samplesOf(it->x, spans); samples != 0)
                found(it->index, samples);
    }
}

}  // namespace wend
