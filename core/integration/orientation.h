#pragma once

#include <memory>

#include "core/mesh/simplicial_mesh.h"

namespace wend {

/// Detects cells of a shape that are inverted relative to the rest mesh (whose cells have one orientation).
template <int Dim>
class Orientation {
  public:
    explicit Orientation(std::shared_ptr<const SimplicialMesh<Dim>> rest);

    /// Returns the first cell whose measure has another sign than at rest, is NaN, or is so small relative to
    /// its edge lengths that rounding determines the sign, however the same coordinates are combined; −1 for
    /// none. Such a shape stays free of inverted cells when it is read again.
    int firstInverted(const Points<Dim>& shape) const;
    /// Returns the cell with the smallest measure relative to rest.
    int mostShrunk(const Points<Dim>& shape) const;

  private:
    std::shared_ptr<const SimplicialMesh<Dim>> m_rest;
    double m_sign;
    std::vector<double> m_minimum;  // per cell: the least measure over that of a cube on its longest edge
};

}  // namespace wend
