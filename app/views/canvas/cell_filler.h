#pragma once

#include <QImage>
#include <QTransform>
#include <array>
#include <cstdint>
#include <vector>

#include "core/mesh/simplicial_mesh.h"
#include "warp/outline_pixels.h"

namespace wend {

/// A layer of coloured triangles over an image. Every pixel has the colour of the last triangle that covers
/// its centre, so that neighbours neither overlap nor leave gaps; pixels on the outline have the visible
/// share of each. QPainter's paths take several times as long.
class CellFiller {
  public:
    /// Fills an image of that size; `toPixels` maps `points` to its pixels.
    CellFiller(const QSize& size, const PaintingPlan& plan, const Points2& points,
               const QTransform& toPixels);

    /// Fills a cell with a colour that is not premultiplied.
    void fill(const Cell<2>& cell, QRgb colour);
    /// Fills with interpolated colours of the corners (premultiplied red, green, blue, alpha from 0 to 255).
    using Colour = Eigen::Array4d;
    void fill(const Cell<2>& cell, const std::array<Colour, 3>& colours);
    /// Fills with the colours of a ramp (premultiplied), in which the corners have positions from 0 to 1.
    void fill(const Cell<2>& cell, const std::array<double, 3>& places, const std::vector<QRgb>& ramp);

    /// The extent of the layer: the whole shape, or only opaque places of the image that shows the picture.
    enum class Extent { Shape, Picture };
    void layOver(QImage& image, Extent extent);

  private:
    /// The part of an outline pixel that a triangle covers.
    struct Piece {
        int band, pixel;
        std::uint64_t samples;
        QRgb colour;
    };
    template <class Value, class ColourOf>
    void fillBetween(const Cell<2>& cell, const std::array<Value, 3>& corners, const ColourOf& colourOf);
    template <class ColourAt>
    void addPieces(const TriangleRows& rows, const ColourAt& colourAt);
    template <class Run>
    void forRows(const TriangleRows& rows, const Run& run);
    void layOutline(QImage& image, Extent extent);

    QPoint m_at;  // of the layer in the image
    QImage m_layer;
    Points2 m_points;  // in the layer's pixels
    OutlinePixels m_outline;
    std::vector<Piece> m_pieces;
};

}  // namespace wend
