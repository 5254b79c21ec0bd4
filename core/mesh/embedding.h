#pragma once

#include "core/mesh/point_locator.h"

namespace wend {

/// Points embedded in a partition, such as a detailed surface in a coarse volume. A point inside is the
/// barycentric combination of its cell; a point at a vertex is that vertex, bit for bit. A point outside
/// follows its nearest boundary point x with the local deformation: x + G (p − X), where G, the deformation
/// gradient, is the volume-weighted mean over the cells at each boundary vertex, interpolated between
/// vertices. So neighbours outside stay neighbours, and affine maps are reproduced exactly.
template <int Dim>
class Embedding {
  public:
    /// Locates the points in the rest mesh. Throws InputError that numbers the point if there is no cell, or
    /// if it is not finite.
    Embedding(const SimplicialMesh<Dim>& rest, const Points<Dim>& points);

    /// Returns the points in a pose (both Dim × n). At rest they equal the originals bit for bit (except for
    /// coordinates near zero).
    Points<Dim> carry(const SimplicialMesh<Dim>& rest, const Points<Dim>& pose) const;
    /// Returns other values of the vertices, interpolated at the points.
    Points<Dim> interpolate(const SimplicialMesh<Dim>& rest, const Points<Dim>& values) const;
    /// Returns the vertices and weights of a point, which sum to 1 up to rounding. A point inside has no
    /// weights of 0; those of a point outside may be negative.
    std::vector<std::pair<int, double>> weights(const SimplicialMesh<Dim>& rest, int point) const;
    /// Returns the cell that a point follows.
    int cell(int point) const { return m_locations[static_cast<std::size_t>(point)].cell; }
    /// Returns whether any point differs from the partition's vertices.
    bool isFree() const { return m_isFree; }
    /// Returns the number of points outside all cells.
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
    Points<Dim> m_remainders;  // rounding residuals of the points at rest
};

}  // namespace wend
