#pragma once

#include <stop_token>

#include "core/mesh/simplicial_mesh.h"

namespace wend {

/// A mesh with about so many vertices of the place that a finer one takes up. In the plane its boundary is
/// the finer one's, simplified by no more than the cells are wide; in space it is a cage of cubes (see
/// fitCage), in which gaps narrower than a cube are closed. Throws InputError where there is none; Cancelled.
template <int Dim>
SimplicialMesh<Dim> coarseMesh(const SimplicialMesh<Dim>& fine, int vertices, std::stop_token stop = {});

}  // namespace wend
