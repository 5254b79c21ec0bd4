#pragma once

#include <memory>

#include "core/mesh/simplicial_mesh.h"

namespace wend {

/// Which cells of a shape are turned over against the rest mesh (whose cells are all of one orientation).
template <int Dim>
class Orientation {
  public:
    explicit Orientation(std::shared_ptr<const SimplicialMesh<Dim>> rest);

    /// The first cell whose measure is of the other sign than at rest, not a number, or so next to zero, for
    /// the length of its edges, that rounding decides its sign: a shape without any has none either where it
    /// is read again with the same numbers, however these are combined. −1 if there is none.
    int firstInverted(const Points<Dim>& shape) const;
    /// The cell whose measure is the least part of that at rest.
    int mostShrunk(const Points<Dim>& shape) const;

  private:
    std::shared_ptr<const SimplicialMesh<Dim>> m_rest;
    double m_sign;
    std::vector<double> m_minimum;  // per cell: the least measure over that of a cube on its longest edge
};

}  // namespace wend
