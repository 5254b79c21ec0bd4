#pragma once

#include <QImage>
#include <QTransform>
#include <array>
#include <vector>

#include "core/mesh/simplicial_mesh.h"

namespace wend {

/// Fills triangles, without smooth borders: every pixel whose centre a triangle covers, so
/// that neighbours share none. QPainter makes a path of each triangle, which takes several times as long.
class CellFiller {
  public:
    /// Onto an image of premultiplied colours, which must not be touched otherwise in its life; `points` are
    /// brought to pixels by `toPixels`.
    CellFiller(QImage& image, const Points<2>& points, const QTransform& toPixels);

    /// Over what is there. The colour is not premultiplied.
    void fill(const Cell<2>& cell, QRgb colour);
    /// The same in colours of the corners (red, green, blue, alpha, premultiplied, from 0 to 255) and what
    /// lies between them.
    using Colour = Eigen::Array4d;
    void fill(const Cell<2>& cell, const std::array<Colour, 3>& colours);
    /// The same in the colours of a ramp (premultiplied), in which the corners have places from 0 to 1.
    void fill(const Cell<2>& cell, const std::array<double, 3>& places, const std::vector<QRgb>& ramp);

  private:
    template <class Value, class ColourOf>
    void fillBetween(const Cell<2>& cell, const std::array<Value, 3>& corners, const ColourOf& colourOf);

    QRgb* m_first;
    std::ptrdiff_t m_stride;
    int m_width, m_height;
    Points<2> m_points;
};

}  // namespace wend
