#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

#include "core/mesh/simplicial_mesh.h"
#include "warp/coverage.h"

namespace wend {

/// The samples in eight rows of places, eight to a pixel, that a triangle covers in one row of pixels.
class SampleRows {
  public:
    /// Handles row `y`, in which the triangle covers the pixels between columns `left` and `right`.
    SampleRows(const TriangleRows& rows, int y, double left, double right);

    /// Return the first pixel with a sample, and the one after the last.
    int begin() const { return m_least >> 3; }
    int end() const { return (m_most + 7) >> 3; }
    /// Returns the samples of a pixel: bit 8 j + i is the place ((i + ½) / 8, (j + ½) / 8) in it.
    std::uint64_t at(int x) const {
        const int first = 8 * x;
        if (m_allFrom <= first && m_allTo >= first + 8) return ~std::uint64_t{0};
        std::uint64_t samples = 0;
        for (std::size_t j = 0; j < 8; ++j) {
            const int from = std::clamp(m_from[j] - first, 0, 8), to = std::clamp(m_to[j] - first, 0, 8);
            if (from < to) samples |= std::uint64_t{(0xFFU >> (8 - to)) & (0xFFU << from)} << (8 * j);
        }
        return samples;
    }

  private:
    std::array<int, 8> m_from{}, m_to{};  // samples of each row, counted from the picture's left side
    int m_least, m_most = 0;              // of all rows
    int m_allFrom = 0, m_allTo;           // that all rows cover
};

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
    OutlinePixels(const PaintingPlan& plan, const Points2& pixels, int width, int height, int bandRows);

    /// Returns the pixels by rows, then from left to right.
    const std::vector<Pixel>& pixels(int band) const {
        return m_bands[static_cast<std::size_t>(band)].pixels;
    }

    /// A bit for each pixel of a band, set for those on the outline; without any, nothing.
    using Marks = std::vector<std::uint64_t>;
    const Marks& marks(int band) const { return m_bands[static_cast<std::size_t>(band)].marks; }
    void remove(int band, const Pixel& pixel, Marks& marks) const {
        marks[wordOf(pixel.y - band * m_bandRows, pixel.x / kWord)] &=
            ~(std::uint64_t{1} << (pixel.x % kWord));
    }

    /// Calls found(index, samples) for all pixels of the band of which the triangle covers something; bit 8 j
    /// + i is the place ((i + ½) / 8, (j + ½) / 8) in the pixel.
    template <typename Found>
    void visit(int band, const TriangleRows& rows, Found&& found) const {
        visit(band, marks(band), rows, found);
    }
    /// Does the same for those pixels that are marked. The function may remove their marks.
    template <typename Found>
    void visit(int band, const Marks& wanted, const TriangleRows& rows, Found&& found) const;

  private:
    static constexpr int kWord = 64;  // columns
    struct Band {
        std::vector<Pixel> pixels;
        Marks marks;              // of kWord columns in a row, row after row; or empty
        std::vector<int> before;  // number of pixels in earlier marks
    };
    void list(int band);
    std::size_t wordOf(int row, int word) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(m_words) +
               static_cast<std::size_t>(word);
    }

    /// Returns the marks of a word of a row from one column to before another.
    std::uint64_t between(const Marks& marks, int row, int word, int from, int to) const {
        std::uint64_t wanted =
            marks[wordOf(row, word)] & (~std::uint64_t{0} << std::max(0, from - word * kWord));
        if (to - word * kWord < kWord) wanted &= (std::uint64_t{1} << (to - word * kWord)) - 1;
        return wanted;
    }
    bool hasAny(const Marks& marks, int row, int from, int to) const {
        for (int word = from / kWord; word * kWord < to; ++word)
            if (between(marks, row, word, from, to) != 0) return true;
        return false;
    }

    int m_bandRows = 1, m_width = 0, m_words = 0;
    std::vector<Band> m_bands;
};

template <typename Found>
void OutlinePixels::visit(int band, const Marks& wanted, const TriangleRows& rows, Found&& found) const {
    if (wanted.empty()) return;
    const Band& own = m_bands[static_cast<std::size_t>(band)];
    const int left = static_cast<int>(std::clamp<double>(std::floor(rows.left()), 0, m_width));
    const int right = static_cast<int>(std::clamp<double>(std::ceil(rows.right()), 0, m_width));
    const int bandTop = band * m_bandRows, bandEnd = bandTop + m_bandRows;
    const int begin = static_cast<int>(std::max<double>(bandTop, std::floor(rows.top())));
    for (int y = begin; y < bandEnd && y < rows.bottom(); ++y) {
        const int row = y - bandTop;
        if (!hasAny(wanted, row, left, right)) continue;
        const SampleRows samples(rows, y, left, right);
        const int from = std::max(left, samples.begin()), to = std::min(right, samples.end());
        for (int word = from / kWord; word * kWord < to; ++word) {
            const std::uint64_t all = own.marks[wordOf(row, word)];
            for (auto rest = between(wanted, row, word, from, to); rest != 0; rest &= rest - 1) {
                const std::uint64_t covered = samples.at(word * kWord + std::countr_zero(rest));
                const int before = std::popcount(all & ~rest & (rest - 1));
                if (covered != 0) found(own.before[wordOf(row, word)] + before, covered);
            }
        }
    }
}

}  // namespace wend
