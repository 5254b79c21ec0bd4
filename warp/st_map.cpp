#include <bit>

#include "core/base/error.h"
#include "warp/cell_map.h"
#include "warp/coverage.h"
#include "warp/outline_pixels.h"
#include "warp/warp.h"
#include "warp/warp_job.h"

namespace wend {
namespace {

Image floatImage(int width, int height) {
    Image image{width, height, 4, PixelType::Float, true, false, {}, nullptr};
    image.makePixels();
    return image;
}

const Cell<2>& cellOf(const SimplicialMesh<2>& mesh, int cell) {
    return mesh.cells[static_cast<std::size_t>(cell)];
}

/// Writes the source position of every pixel whose centre is covered by a cell.
class StPainter {
  public:
    StPainter(const Points2& from, const Points2& to, const View& view, double width, double height)
        : m_from(from),
          m_to(to),
          m_view(view),
          m_width(width),
          m_height(height),
          m_image(floatImage(view.width, view.height)) {}

    void paint(const Cell<2>& cell) {
        const CellMap map(m_from, m_to, cell);
        const TriangleRows rows = rowsOf(cell);
        for (int y = firstPixel(rows.top(), m_view.height); y < m_view.height && y + 0.5 < rows.bottom();
             ++y) {
            const Span span = rows.at(y + 0.5);
            for (int x = firstPixel(span.begin, m_view.width); x < firstPixel(span.end, m_view.width); ++x)
                put(map, x, y, 1);
        }
    }

    TriangleRows rowsOf(const Cell<2>& cell) const {
        return {pixel(cell[0]), pixel(cell[1]), pixel(cell[2])};
    }

    /// Writes a pixel on the outline: the position in the cell that covers most of it, and the coverage as
    /// alpha.
    void put(const CellMap& map, int x, int y, float coverage) {
        const Vec2 p = m_view.origin + m_view.scale * Vec2(x + 0.5, y + 0.5);
        const Vec2 source = map.source(p);
        float* pixel = reinterpret_cast<float*>(m_image.row(y)) + 4 * x;
        pixel[0] = static_cast<float>(source.x() / m_width);
        pixel[1] = static_cast<float>(1 - source.y() / m_height);
        pixel[2] = 0;
        pixel[3] = coverage;
    }

    Image take() { return std::move(m_image); }

  private:
    Vec2 pixel(int vertex) const { return (m_to.col(vertex) - m_view.origin) / m_view.scale; }

    const Points2& m_from;
    const Points2& m_to;
    const View& m_view;
    double m_width, m_height;
    Image m_image;
};

/// Chooses for every outline pixel the cell with the largest visible share, from the nearest down.
void paintOutline(StPainter& painter, const SimplicialMesh<2>& rest, const Points2& from, const Points2& to,
                  const View& view, const PaintingPlan& plan) {
    const Points2 pixels = (to.colwise() - view.origin) / view.scale;
    const OutlinePixels outline(plan, pixels, view.width, view.height, view.height);
    struct Best {
        int cell = -1, most = 0;
        std::uint64_t samples = 0;
    };
    std::vector<Best> best(outline.pixels(0).size());
    for (auto it = plan.order.rbegin(); it != plan.order.rend(); ++it)
        outline.visit(0, painter.rowsOf(cellOf(rest, *it)), [&](int index, std::uint64_t samples) {
            Best& at = best[static_cast<std::size_t>(index)];
            const int shown = std::popcount(samples & ~at.samples);
            at.samples |= samples;
            if (shown > at.most) at.cell = *it, at.most = shown;
        });
    for (const auto& pixel : outline.pixels(0)) {
        const Best& at = best[static_cast<std::size_t>(pixel.index)];
        if (at.cell < 0) continue;
        painter.put(CellMap(from, to, cellOf(rest, at.cell)), pixel.x, pixel.y,
                    static_cast<float>(std::popcount(at.samples)) / 64);
    }
}

}  // namespace

Image stMap(const SimplicialMesh<2>& rest, const Points2& pose, const View& view, int sourceWidth,
            int sourceHeight, const std::vector<float>& depth, bool inverse) {
    if (!pose.allFinite()) throw InputError("the shape has a vertex that is not a finite number");
    if (view.width <= 0 || view.height <= 0) return floatImage(0, 0);
    const Points2& from = inverse ? pose : rest.points;
    const Points2& to = inverse ? rest.points : pose;
    StPainter painter(from, to, view, sourceWidth, sourceHeight);
    const PaintingPlan plan(rest, depth);
    for (const int cell : plan.order) painter.paint(cellOf(rest, cell));
    paintOutline(painter, rest, from, to, view, plan);
    Image image = painter.take();
    image.place = placeOf(view, sourceWidth, sourceHeight);
    return image;
}

}  // namespace wend
