#pragma once

#include <QPainter>
#include <array>
#include <memory>
#include <vector>

#include "app/tools/shape_view.h"

namespace wend {

class Playback;
class ShapeMotion;
template <int Dim>
class Embedding;

/// Draws ghosts of the shape before and after the shown time: three in each direction, a tenth of the film
/// apart, in two colours, fading with distance. For a picture they show the drawing without the transparent
/// margin. Hidden during playback.
template <int Dim>
class OnionSkin {
  public:
    void setShown(bool shown) { m_shown = shown; }
    /// Drawn below a picture; solids have outlines only.
    void paintFills(QPainter& painter, ShapeView& view);
    void paintOutlines(QPainter& painter, ShapeView& view);
    /// Draws a rim around the shown shape, even without the skins; drawn below it, only the outer half is
    /// visible.
    void paintRim(QPainter& painter, ShapeView& view, const PosedFrame<Dim>& frame);

  private:
    using Loop = std::vector<int>;
    struct Layer {
        PosedPtr<Dim> frame;
        QColor colour;  // of the tint
    };
    /// A line between two corners, and the triangles at its sides (the second −1 at an end of the surface).
    struct Edge {
        int from, to;
        std::array<int, 2> sides;
    };
    std::vector<Layer> layers(const ShapeMotion& motion, const Playback& playback) const;
    void takeBoundary(const PosedFrame<Dim>& frame);
    void takeDrawing(const Shape<Dim>& shape);
    std::vector<QPolygonF> outline(const PosedFrame<Dim>& frame, ShapeView& view) const;

    bool m_shown = false;
    std::shared_ptr<const SimplicialMesh<Dim>> m_rest;  // owner of the boundary
    std::vector<Loop> m_loops;                          // in the plane closed lines,
    std::shared_ptr<const Embedding<Dim>> m_drawn;      // of the points of these, if they are no vertices;
    std::vector<std::array<int, 3>> m_triangles;        // visible triangles of a solid
    std::vector<Edge> m_edges;
    bool m_isEmbedded = false;  // those of the surface embedded in it
};

}  // namespace wend
