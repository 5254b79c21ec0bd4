#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "core/mesh/simplicial_mesh.h"

namespace wend {

/// The part of a row that a triangle covers: positions x with begin ≤ x < end.
struct Span {
    double begin = 0, end = 0;
};

/// Rows of a triangle in the plane of the output's pixels. The borders of two triangles with a common edge
/// are the same numbers, computed from the edge alone, so that every position belongs to exactly one of them.
class TriangleRows {
  public:
    /// Takes corners in output pixels.
    TriangleRows(const Vec2& a, const Vec2& b, const Vec2& c);
    double top() const { return m_corners[0].y(); }
    double bottom() const { return m_corners[2].y(); }
    double left() const { return std::min({m_corners[0].x(), m_corners[1].x(), m_corners[2].x()}); }
    double right() const { return std::max({m_corners[0].x(), m_corners[1].x(), m_corners[2].x()}); }
    /// Returns the span at height y, top() ≤ y < bottom().
    Span at(double y) const {
        const double along = m_long.at(y);
        const double other = y < m_corners[1].y() ? m_upper.at(y) : m_lower.at(y);
        return {std::min(along, other), std::max(along, other)};
    }

  private:
    /// An edge's x over y, from its upper end.
    struct Edge {
        double x, y, slope;
        Edge(const Vec2& upper, const Vec2& lower)
            : x(upper.x()), y(upper.y()), slope((lower.x() - upper.x()) / (lower.y() - upper.y())) {}
        double at(double height) const { return x + (height - y) * slope; }
    };
    using Corners = std::array<Vec2, 3>;
    explicit TriangleRows(const Corners& sorted)
        : m_corners(sorted),
          m_long(sorted[0], sorted[2]),
          m_upper(sorted[0], sorted[1]),
          m_lower(sorted[1], sorted[2]) {}
    static Corners sorted(Corners corners);

    Corners m_corners;  // by height, then from left to right
    Edge m_long, m_upper, m_lower;
};

/// Data shared by all poses of a mesh with these depths of cells (see WarpOptions; empty: equal).
struct PaintingPlan {
    PaintingPlan(const SimplicialMesh<2>& mesh, const std::vector<float>& depth);

    std::vector<int> order;                   // of the cells: the last one is on top
    std::vector<std::array<int, 2>> outline;  // edges of the shape, and of parts in front of others
};

}  // namespace wend
