#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
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
    /// Places a cell over those that came before.
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

/// The cells that are seen at the pixel centres of some rows, which come from the front to the back: what
/// lies below an opaque colour is neither painted nor listed.
class SeenCells {
  public:
    SeenCells() = default;
    SeenCells(int width, int top, int rows)
        : m_width(width),
          m_top(top),
          m_states(static_cast<std::size_t>(width) * static_cast<std::size_t>(rows), State::Free),
          m_pixels(std::make_unique_for_overwrite<Pixel[]>(m_states.size())) {}

    bool empty() const { return m_states.empty(); }
    /// Returns whether a cell covers the pixel.
    bool covers(int pixel) const { return m_states[static_cast<std::size_t>(pixel)] != State::Free; }
    /// Returns whether the front cell of the pixel is opaque there.
    bool hidesAll(int pixel) const { return m_states[static_cast<std::size_t>(pixel)] == State::Hidden; }

    /// Adds a cell behind those that came before. Calls paint(from, to, isFirst) for the runs of pixels where
    /// it is seen: it returns a function that says of a pixel of the run whether the cell is opaque there. A
    /// run is the first one of its pixels if nothing is in front of them.
    template <typename Paint>
    void add(int y, int from, int to, int cell, Paint&& paint) {
        const int first = (y - m_top) * m_width;
        const State* const row = m_states.data() + first;
        for (int x = from; x < to;) {
            const State state = row[x];
            int end = x + 1;
            while (end < to && row[end] == state) ++end;
            if (state < State::Closed) {
                const auto isOpaque = paint(x, end, state == State::Free);
                for (; x < end; ++x) put(first + x, cell, isOpaque(x));
            }
            x = end;
        }
    }

    /// Calls visit(pixel, cells) for all pixels at which several cells are seen, with the cells from the top
    /// one down.
    template <typename Visit>
    void forOverlaps(Visit&& visit) const {
        std::vector<int> cells;
        for (const int pixel : m_overlapped) {
            const Pixel& own = m_pixels[static_cast<std::size_t>(pixel)];
            cells.clear();
            for (int at = own.lowest; at >= 0; at = m_below[static_cast<std::size_t>(at)].above)
                cells.push_back(m_below[static_cast<std::size_t>(at)].cell);
            cells.push_back(own.front);
            std::reverse(cells.begin(), cells.end());
            visit(pixel, std::span<const int>(cells));
        }
    }

  private:
    enum class State : std::uint8_t { Free, Open, Closed, Hidden };  // Hidden: closed by its first cell
    struct Pixel {
        int front, lowest;  // the first cell, and the place of the last other one in m_below, or −1
    };
    struct Below {
        int cell, above;
    };

    void put(int pixel, int cell, bool closes) {
        State& state = m_states[static_cast<std::size_t>(pixel)];
        if (state == State::Free && closes) {
            state = State::Hidden;
            return;
        }
        Pixel& own = m_pixels[static_cast<std::size_t>(pixel)];
        if (state == State::Free) {
            own = {cell, -1};
        } else {
            if (own.lowest < 0) m_overlapped.push_back(pixel);
            m_below.push_back({cell, own.lowest});
            own.lowest = static_cast<int>(m_below.size()) - 1;
        }
        state = closes ? State::Closed : State::Open;
    }

    int m_width = 0, m_top = 0;
    std::vector<State> m_states;
    std::unique_ptr<Pixel[]> m_pixels;  // of those that were open
    std::vector<int> m_overlapped;
    std::vector<Below> m_below;
};

}  // namespace wend
