#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

namespace wend {

/// The cells that cover the pixel centres of some rows: the top one, and all of them where the shape overlaps
/// itself.
class PixelCells {
  public:
    PixelCells() = default;
    PixelCells(int width, int top, int rows)
        : m_width(width),
          m_top(top),
          m_onTop(static_cast<std::size_t>(width) * static_cast<std::size_t>(rows), -1) {}

    bool empty() const { return m_onTop.empty(); }
    /// A cell over those that came before.
    void cover(int y, int from, int to, int cell) {
        const int first = (y - m_top) * m_width;
        for (int pixel = first + from; pixel < first + to; ++pixel) {
            int& onTop = m_onTop[static_cast<std::size_t>(pixel)];
            if (onTop >= 0) m_below.push_back({pixel, onTop});
            onTop = cell;
        }
    }

    /// Returns the top cells row by row; −1 for none.
    const std::vector<int>& onTop() const { return m_onTop; }

    /// Calls visit(pixel, cells) for all pixels that several cells cover, with the cells from the top one
    /// down.
    template <typename Visit>
    void forOverlaps(Visit&& visit) {
        std::stable_sort(m_below.begin(), m_below.end(),
                         [](const Below& a, const Below& b) { return a.pixel < b.pixel; });
        std::vector<int> cells;
        for (auto it = m_below.begin(); it != m_below.end();) {
            const int pixel = it->pixel;
            cells.clear();
            for (; it != m_below.end() && it->pixel == pixel; ++it) cells.push_back(it->cell);
            cells.push_back(m_onTop[static_cast<std::size_t>(pixel)]);
            std::reverse(cells.begin(), cells.end());
            visit(pixel, std::span<const int>(cells));
        }
    }

  private:
    struct Below {
        int pixel, cell;
    };

    int m_width = 0, m_top = 0;
    std::vector<int> m_onTop;
    std::vector<Below> m_below;  // in painting order
};

}  // namespace wend
