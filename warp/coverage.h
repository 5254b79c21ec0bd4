#pragma once

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
    /// Corners in output pixels.
    TriangleRows(const Vec<2>& a, const Vec<2>& b, const Vec<2>& c);
    double top() const { return m_corners[0].y(); }
    double bottom() const { return m_corners[2].y(); }
    /// The span at height y, top() ≤ y < bottom().
    Span at(double y) const;

  private:
    std::array<Vec<2>, 3> m_corners;  // by height, then from left to right
};

/// Cells in the order in which they are painted: the last one lies on top.
std::vector<int> paintingOrder(int cells, const std::vector<float>& depth);

}  // namespace wend
