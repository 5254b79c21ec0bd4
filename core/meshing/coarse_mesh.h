#pragma once

#include <stop_token>

#include "core/mesh/simplicial_mesh.h"

namespace wend {

/// Returns a mesh with about that many vertices of the same domain. In the plane its boundary is that of the
/// fine mesh, simplified by no more than a cell's width; in space it is a cage of cubes (see fitCage). Throws
/// InputError if there is none: for a planar shape that overlaps itself, or if cubes would connect separate
/// parts, such as two fingers; Cancelled.
template <int Dim>
SimplicialMesh<Dim> coarseMesh(const SimplicialMesh<Dim>& fine, int vertices, std::stop_token stop = {});

}  // namespace wend
