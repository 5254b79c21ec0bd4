#pragma once

#include "core/mesh/point_locator.h"

namespace wend {

/// Points embedded in a partition: a detailed surface in a coarse volume. A point inside takes the
/// barycentric combination of its cell, one at the place of a vertex is that vertex, bit for bit. One outside
/// stays in front of the nearest point of the boundary, x, as the material there turns and stretches:
/// x + G (p − X), where G, the deformation gradient, is the mean of the cells around (by volume) at each of
/// the boundary's vertices, interpolated between them. So neighbours outside stay neighbours, and affine maps
/// are followed exactly.
template <int Dim>
class Embedding {
  public:
    Embedding(const SimplicialMesh<Dim>& rest, const Points<Dim>& points);

    /// Where the points are in a pose. At rest they are where they were, bit for bit (but for coordinates of
    /// next to nothing).
    Points<Dim> carry(const SimplicialMesh<Dim>& rest, const Points<Dim>& pose) const;
    /// Other values of the vertices, at the points.
    Points<Dim> interpolate(const SimplicialMesh<Dim>& rest, const Points<Dim>& values) const;
    /// The vertices whose combination a point is, and how much of each.
    std::vector<std::pair<int, double>> weights(const SimplicialMesh<Dim>& rest, int point) const;
    /// The cell that a point goes with.
    int cell(int point) const { return m_locations[static_cast<std::size_t>(point)].cell; }
    /// Whether any lies elsewhere than at a vertex: then they are not just the partition's own.
    bool isFree() const { return m_isFree; }
    /// How many lie outside all cells.
    int outside() const { return static_cast<int>(m_rows.size()); }

  private:
    class Outside;
    struct Row {  // of the combinations of vertices that points outside are
        int point;
        std::vector<std::pair<int, double>> weights;
    };
    std::vector<Location<Dim>> m_locations;
    std::vector<Row> m_rows;
    bool m_isFree = false;
    Points<Dim> m_remainders;  // what rounding leaves of the points at rest
};

}  // namespace wend
