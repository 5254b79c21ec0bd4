#pragma once

#include <stop_token>

#include "core/mesh/simplicial_mesh.h"

namespace wend {

/// A mesh with about so many vertices of the place that a finer one takes up. In the plane its boundary is
/// the finer one's, simplified by no more than the cells are wide; in space it is a cage of cubes (see
/// fitCage). Throws InputError where there is none: a shape that covers itself in the plane, or cubes that
/// would hold together what is apart, as two fingers or the jaws of tongs; Cancelled.
template <int Dim>
SimplicialMesh<Dim> coarseMesh(const SimplicialMesh<Dim>& fine, int vertices, std::stop_token stop = {});

}  // namespace wend
