#pragma once

#include "core/mesh/point_locator.h"

namespace wend {

/// Points that ride in a partition: a detailed surface in a coarse volume. A point inside takes the
/// barycentric combination of its cell, one at the place of a vertex is that vertex, bit for bit; one outside
/// the affine map of the nearest vertex's cell that reaches out to it best.
template <int Dim>
class Embedding {
  public:
    Embedding(const SimplicialMesh<Dim>& rest, const Points<Dim>& points);

    /// Where the points are in a pose. At rest they are where they were, to rounding.
    Points<Dim> carry(const SimplicialMesh<Dim>& rest, const Points<Dim>& pose) const;
    /// The cell that a point goes with.
    int cell(int point) const { return m_locations[static_cast<std::size_t>(point)].cell; }
    /// How many lie outside all cells.
    int outside() const { return m_outside; }

  private:
    std::vector<Location<Dim>> m_locations;
    int m_outside = 0;
};

}  // namespace wend
