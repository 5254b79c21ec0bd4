#pragma once

#include <functional>
#include <numeric>
#include <ranges>
#include <span>

#include "warp/blended_layers.h"
#include "warp/pixel_cells.h"
#include "warp/span_task.h"
#include "warp/warp_job.h"

namespace wend {

/// Paints the rows of one band of a picture of numbers of type T: the cells in painting order, the outside,
/// what shows through where the shape overlaps itself, and the outline's pixels.
template <typename T>
class BandPainter {
  public:
    BandPainter(const WarpJob& job, int band, BandPart part, Image& strip, int top)
        : m_job(job),
          m_part(part),
          m_top(top),
          m_band(band),
          m_begin(band * kBandRows),
          m_end(std::min(job.view.height, m_begin + kBandRows)),
          m_channels(job.header.channels),
          m_stride(static_cast<std::ptrdiff_t>(job.view.width) * m_channels),
          m_pixels(reinterpret_cast<T*>(strip.data.data())),
          m_paintSpan(spanPainterOf<T>(job.source->base().channels, job.options.filter)) {
        m_task.left = job.view.origin.x(), m_task.scale = job.view.scale, m_task.addsAlpha = job.addsAlpha;
        m_task.isQuick = job.options.isQuick;
        for (int k = 0; k < job.source->levels(); ++k) m_levels.push_back(level(job.source->level(k)));
        m_shinesThrough = part == BandPart::All && (!job.source->opaque() || !job.options.blends.empty());
        if (m_shinesThrough || job.options.outside != Outside::Transparent)
            m_cells = SeenCells(job.view.width, m_begin, m_end - m_begin);
        if (m_shinesThrough) m_row.resize(static_cast<std::size_t>(job.view.width * m_channels));
    }

    void paint() {
        const std::vector<int>& cells = m_job.cellsOfBand[static_cast<std::size_t>(m_band)];
        if (!m_cells.empty())
            for (const int cell : std::views::reverse(cells)) paintSeen(cell);
        else if (m_part == BandPart::All)
            for (const int cell : cells) paintCell(cell);
        fillOutside();
        if (m_shinesThrough) resolveOverlaps();
        resolveOutline();
    }

  private:
    T* target(int x, int y) {
        return m_pixels + static_cast<std::ptrdiff_t>(y - m_top) * m_stride +
               static_cast<std::ptrdiff_t>(x) * m_channels;
    }

    /// Returns the height of a row's centres. A vector of both coordinates would be stored by halves and
    /// loaded as a whole, for which the processor waits until all that was painted before is stored.
    double heightOf(int y) const { return m_job.view.origin.y() + m_job.view.scale * (y + 0.5); }

    TexelLevel level(const Image& image) const {
        return {image.data.data(), image.width, image.height, image.unassociated && !m_job.source->opaque(),
                image.alpha};
    }

    // --- cells
    // ---------------------------------------------------------------------------------------------------

    const TexelLevel& levelOf(const CellFilter& filter) const {
        return m_levels[static_cast<std::size_t>(filter.level)];
    }

    /// Returns whether all pixels needed for positions in a box are inside the picture.
    bool inner(const Vec2& low, const Vec2& high, const CellFilter& filter) const {
        const TexelLevel& level = levelOf(filter);
        const Eigen::Vector2i& reach = filter.ellipse.wholeReach;
        return low.x() * filter.shrink >= reach.x() + 2 && low.y() * filter.shrink >= reach.y() + 2 &&
               high.x() * filter.shrink + reach.x() + 7 < level.width &&
               high.y() * filter.shrink + reach.y() + 3 < level.height;
    }

    /// Calls visit(y, from, to) for the runs of pixels that a cell covers, after m_task was set for them.
    template <typename Visit>
    void forRunsOf(int place, Visit&& visit) {
        const VisibleCell& cell = m_job.cells[static_cast<std::size_t>(place)];
        m_task.level = levelOf(cell.filter);
        m_task.setCell(cell.map, cell.filter);
        const bool allInner = cell.map.exact && inner(cell.low, cell.high, cell.filter);
        forRuns(cell.rows, m_begin, m_end, m_job.view.width, [&](int y, int from, int to) {
            m_task.begin = from, m_task.end = to;
            m_task.setRow(cell.map, heightOf(y));
            m_task.inner = allInner || (cell.map.exact && innerSpan(cell, y));
            visit(y, from, to);
        });
    }

    void paintCell(int place) {
        forRunsOf(place,
                  [&](int y, int from, int) { m_paintSpan(m_task, SpanOutput::Pixels, target(from, y)); });
    }

    /// Paints what is seen of a cell, which is behind those that were painted before.
    void paintSeen(int place) {
        const bool mayHide = m_job.cells[static_cast<std::size_t>(place)].blend == BlendMode::Normal;
        forRunsOf(place, [&](int y, int from, int to) {
            m_cells.add(y, from, to, place, [&](int begin, int end, bool isFirst) {
                T* const pixels = isFirst ? target(begin, y) : m_row.data();
                m_task.begin = begin, m_task.end = end;
                if (m_part == BandPart::All) m_paintSpan(m_task, SpanOutput::Pixels, pixels);
                const T* const alpha = pixels + m_channels - 1;
                return [=, this](int x) {
                    return !m_shinesThrough || (mayHide && isFull(alpha[(x - begin) * m_channels]));
                };
            });
        });
    }

    static bool isFull(T alpha) { return !(static_cast<float>(alpha) < kFull<T>); }

    bool innerSpan(const VisibleCell& cell, int y) const {
        const Vec2 a = cell.map.source(m_job.plane(m_task.begin + 0.5, y + 0.5));
        const Vec2 b = cell.map.source(m_job.plane(m_task.end - 0.5, y + 0.5));
        return inner(a.cwiseMin(b), a.cwiseMax(b), cell.filter);
    }

    /// Samples a map with a filter at the centre of a pixel.
    OutColour sample(const CellMap& map, const CellFilter& filter, int x, int y) const {
        SpanTask task = m_task;
        task.level = levelOf(filter);
        task.begin = x, task.end = x + 1;
        task.inner = false;
        task.setCell(map, filter);
        task.setRow(map, heightOf(y));
        OutColour colour{};
        m_paintSpan(task, SpanOutput::Colour, colour.data());
        const int channels = m_job.source->base().channels;
        std::fill(colour.begin() + channels, colour.end(), 0.0F);
        if (m_job.addsAlpha) colour[static_cast<std::size_t>(channels)] = kFull<T>;
        return colour;
    }

    // --- outside the shape
    // ---------------------------------------------------------------------------------------

    bool inPicture(const Vec2& p) const {
        const Image& image = m_job.source->base();
        return p.x() >= 0 && p.y() >= 0 && p.x() < image.width && p.y() < image.height;
    }

    OutColour givenColour() const {
        OutColour colour{};
        const auto& given = m_job.options.colour;
        const bool alpha = m_job.header.alpha;
        const int colours = m_channels - (alpha ? 1 : 0);
        const float divide = m_job.header.unassociated && given[3] > 0 ? given[3] : 1;
        for (int c = 0; c < colours; ++c)
            colour[static_cast<std::size_t>(c)] =
                given[static_cast<std::size_t>(std::min(c, 2))] / divide * kFull<T>;
        if (alpha) colour[static_cast<std::size_t>(colours)] = given[3] * kFull<T>;
        return colour;
    }

    OutColour outsideColour(int x, int y) const {
        const Vec2 p = m_job.plane(x + 0.5, y + 0.5);
        const Outside kind = m_job.options.outside;
        if (kind == Outside::Colour) return givenColour();
        if (kind == Outside::Clamp || (kind == Outside::Original && inPicture(p)))
            return sample(CellMap(), m_job.outsideFilter, x, y);
        return {};
    }

    void putOut(const OutColour& colour, T* to) const {
        for (int c = 0; c < m_channels; ++c) to[c] = toPixel<T>(colour[static_cast<std::size_t>(c)]);
    }

    /// Paints the pixels that no cell covers, which are already transparent in a new strip.
    void fillOutside() {
        if (m_job.options.outside == Outside::Transparent) return;
        for (int y = m_begin, pixel = 0; y < m_end; ++y)
            for (int x = 0; x < m_job.view.width; ++x, ++pixel)
                if (!m_cells.covers(pixel)) putOut(outsideColour(x, y), target(x, y));
    }

    // --- cells over cells
    // ---------------------------------------------------------------------------------------------

    Layers layers() const { return {m_job.header, kFull<T>}; }

    void put(int place, int x, int y, std::uint64_t places, Layers& layers) const {
        if ((places & layers.open()) == 0) return;
        const VisibleCell& cell = m_job.cells[static_cast<std::size_t>(place)];
        layers.put(sample(cell.map, cell.filter, x, y), places);
    }

    /// Adds the other cells where the front cell, whose colour is painted already, is not opaque.
    void resolveOverlaps() {
        m_cells.forOverlaps([&](int pixel, std::span<const int> cells) {
            const int x = pixel % m_job.view.width, y = m_begin + pixel / m_job.view.width;
            T* const to = target(x, y);
            if (isBlended(cells, std::identity())) {
                BlendedLayers<1> seen(m_job.header, kFull<T>);
                for (const int cell : std::views::reverse(cells)) blend(cell, x, y, Layers::kAll, seen);
                return putOut(seen.colour(), to);
            }
            if (isFull(to[m_channels - 1])) return;
            Layers seen = layers();
            for (int cell : cells) put(cell, x, y, Layers::kAll, seen);
            putOut(seen.colour(), to);
        });
    }

    /// Returns whether a part is blended with one below it, in a list of cells from the top one down.
    template <typename List, typename CellOf>
    bool isBlended(const List& list, const CellOf& cellOf) const {
        if (m_job.options.blends.empty() || list.empty()) return false;
        const auto cell = [&](const auto& one) -> const VisibleCell& {
            return m_job.cells[static_cast<std::size_t>(std::invoke(cellOf, one))];
        };
        const int lowest = cell(list.back()).part;
        return std::ranges::any_of(list, [&](const auto& one) {
            return cell(one).blend != BlendMode::Normal && cell(one).part != lowest;
        });
    }

    template <std::size_t Samples>
    void blend(int place, int x, int y, std::uint64_t places, BlendedLayers<Samples>& layers) const {
        const VisibleCell& cell = m_job.cells[static_cast<std::size_t>(place)];
        layers.put(sample(cell.map, cell.filter, x, y), places, cell.part, cell.blend);
    }

    // --- the outline
    // ---------------------------------------------------------------------------------------------

    struct Piece {
        int pixel, cell;
        std::uint64_t samples;
    };

    /// Returns the covered pieces of the outline's pixels, cell by cell from the front to the back, but of
    /// those pixels that show the colour of their front cell alone, which are marked.
    std::vector<Piece> pieces(std::vector<bool>& isShown) const {
        const OutlinePixels& outline = m_job.outline;
        const auto& pixels = outline.pixels(m_band);
        OutlinePixels::Marks open = outline.marks(m_band);
        std::vector<bool> isBegun(pixels.size());
        std::vector<Piece> list;
        for (const int cell : std::views::reverse(m_job.cellsOfBand[static_cast<std::size_t>(m_band)]))
            outline.visit(m_band, open, m_job.cells[static_cast<std::size_t>(cell)].rows,
                          [&](int index, std::uint64_t samples) {
                              const auto at = static_cast<std::size_t>(index);
                              if (!isBegun[at] && samples == Layers::kAll && showsFrontCell(pixels[at])) {
                                  isShown[at] = true;
                                  return outline.remove(m_band, pixels[at], open);
                              }
                              isBegun[at] = true;
                              list.push_back({index, cell, samples});
                          });
        return list;
    }

    /// Returns whether a pixel has the colour of the front cell at its centre, which is opaque.
    bool showsFrontCell(const OutlinePixels::Pixel& pixel) const {
        if (m_part != BandPart::All) return false;
        return !m_shinesThrough || m_cells.hidesAll((pixel.y - m_begin) * m_job.view.width + pixel.x);
    }

    void resolveOutline() {
        const auto& pixels = m_job.outline.pixels(m_band);
        std::vector<bool> isShown(pixels.size());
        const std::vector<Piece> list = pieces(isShown);
        std::vector<std::size_t> ends(pixels.size() + 1);  // of a pixel's pieces, at first of the one before
        for (const Piece& piece : list) ++ends[static_cast<std::size_t>(piece.pixel) + 1];
        std::partial_sum(ends.begin(), ends.end(), ends.begin());
        std::vector<Piece> upwards(list.size());
        for (const Piece& piece : std::views::reverse(list))
            upwards[ends[static_cast<std::size_t>(piece.pixel)]++] = piece;
        std::size_t begin = 0;
        for (const auto& pixel : pixels) {
            const std::size_t end = ends[static_cast<std::size_t>(pixel.index)];
            if (!isShown[static_cast<std::size_t>(pixel.index)])
                resolve(pixel.x, pixel.y, std::span(upwards).subspan(begin, end - begin));
            begin = end;
        }
    }

    /// Composites the cells from the top one down, and the outside where there is none.
    void resolve(int x, int y, std::span<const Piece> pieces) {
        const auto downwards = std::views::reverse(pieces);
        if (isBlended(downwards, &Piece::cell)) return resolveBlended(x, y, pieces);
        Layers seen = layers();
        for (const Piece& piece : downwards) put(piece.cell, x, y, piece.samples, seen);
        if (seen.bare() != 0) seen.put(outsideColour(x, y), seen.bare());
        putOut(seen.colour(), target(x, y));
    }

    void resolveBlended(int x, int y, std::span<const Piece> pieces) {
        BlendedLayers<64> seen(m_job.header, kFull<T>);
        std::uint64_t covered = 0;
        for (const Piece& piece : pieces) covered |= piece.samples;
        if (~covered != 0) seen.put(outsideColour(x, y), ~covered, -1, BlendMode::Normal);
        for (const Piece& piece : pieces) blend(piece.cell, x, y, piece.samples, seen);
        putOut(seen.colour(), target(x, y));
    }

    const WarpJob& m_job;
    BandPart m_part;
    int m_top, m_band, m_begin, m_end, m_channels;
    std::ptrdiff_t m_stride;  // numbers of a row
    T* m_pixels;
    bool m_shinesThrough = false;  // what is below a cell's colours counts
    PaintSpan m_paintSpan;
    SpanTask m_task;
    std::vector<TexelLevel> m_levels;
    SeenCells m_cells;     // if some of them show through others, or the outside is not transparent
    std::vector<T> m_row;  // colours of which only the opacity counts
};

template <typename T>
void paintBand(const WarpJob& job, int band, BandPart part, Image& strip, int top) {
    BandPainter<T>(job, band, part, strip, top).paint();
}

}  // namespace wend
