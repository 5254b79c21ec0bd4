#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "core/mesh/simplicial_mesh.h"
#include "warp/coverage.h"

namespace wend {

/// The pixels that the border of the shape passes through, and which of 8 × 8 places in each a triangle
/// covers.
class OutlinePixels {
  public:
    struct Pixel {
        int x, y, index;  // index: the place in the band's list
    };

    OutlinePixels() = default;
    /// None.
    OutlinePixels(int bands, int bandRows) : m_bandRows(bandRows), m_bands(static_cast<std::size_t>(bands)) {}
    /// `pixels`: the vertices in pixels of the output.
    OutlinePixels(const SimplicialMesh<2>& mesh, const Points<2>& pixels, int width, int height,
                  int bandRows);

    /// By rows, then from left to right.
    const std::vector<Pixel>& pixels(int band) const { return m_bands[static_cast<std::size_t>(band)]; }

    /// Calls found(index, samples) for all pixels of the band of which the triangle covers something; bit 8 j
    /// + i is the place
    /// ((i + ½) / 8, (j + ½) / 8) in the pixel.
    template <typename Found>
    void visit(int band, const TriangleRows& rows, Found&& found) const;

  private:
    int m_bandRows = 1;
    std::vector<std::vector<Pixel>> m_bands;
};

template <typename Found>
void OutlinePixels::visit(int band, const TriangleRows& rows, Found&& found) const {
    const auto& list = m_bands[static_cast<std::size_t>(band)];
    auto it = std::lower_bound(list.begin(), list.end(), static_cast<int>(std::floor(rows.top())),
                               [](const Pixel& p, int y) { return p.y < y; });
    while (it != list.end() && it->y < rows.bottom()) {
        const int y = it->y;
        std::array<Span, 8> spans{};
        double low = 1e300, high = -1e300;
        for (int j = 0; j < 8; ++j) {
            const double at = y + (j + 0.5) / 8;
            if (at < rows.top() || at >= rows.bottom()) continue;
            spans[j] = rows.at(at);
            low = std::min(low, spans[j].begin);
            high = std::max(high, spans[j].end);
        }
        it = std::lower_bound(it, list.end(), std::floor(low),
                              [y](const Pixel& p, double x) { return p.y == y && p.x < x; });
        for (; it != list.end() && it->y == y; ++it) {
            if (it->x >= high) continue;
            std::uint64_t samples = 0;
            for (int j = 0; j < 8; ++j)
                for (int i = 0; i < 8; ++i) {
                    const double x = it->x + (i + 0.5) / 8;
                    if (x >= spans[j].begin && x < spans[j].end) samples |= std::uint64_t{1} << (8 * j + i);
                }
            if (samples != 0) found(it->index, samples);
        }
    }
}

}  // namespace wend
