#pragma once

#include <memory>
#include <optional>

#include "core/mesh/simplicial_mesh.h"

namespace wend {

/// The location of a point in a partition: a cell and barycentric coordinates.
template <int Dim>
struct Location {
    int cell = -1;
    Eigen::Matrix<double, Dim + 1, 1> weights;
};

/// Finds cells that contain points, over a uniform grid of the cells' bounding boxes. Keeps its own copy of
/// nothing but the grid: mesh connectivity and points must outlive it. Building takes about linear time for
/// cells of similar sizes, a query about constant time. Queries may run in several threads at a time.
template <int Dim>
class PointLocator {
  public:
    PointLocator(const Points<Dim>& points, const std::vector<Cell<Dim>>& cells);
    ~PointLocator();
    PointLocator(PointLocator&&) noexcept;

    /// Returns the cell that contains p (with all weights ≥ −tolerance; of several, as at a shared facet or
    /// where the shape overlaps itself, the one of highest index), or nothing. The weights sum to 1. Nothing
    /// is found for a p that is not finite; flat cells and cells with such corners are never found.
    std::optional<Location<Dim>> find(const Vec<Dim>& p, double tolerance = 1e-12) const;
    /// Returns the nearest vertex of a cell (of any vertex if there are no cells), the lowest of several; −1
    /// if there is none or p is not finite.
    int nearestVertex(const Vec<Dim>& p) const;

  private:
    struct Grid;
    std::unique_ptr<Grid> m_grid;
};

}  // namespace wend
