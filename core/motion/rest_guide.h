#pragma once

#include "core/mesh/simplicial_mesh.h"
#include "core/motion/handle.h"

namespace wend {

/// Returns the rest surface between some vertices: the triangles of the boundary (in the plane its edges) of
/// which they have all corners. In space, if there is none, the boundary's edges between them. The guide's
/// points are all of the mesh, so that its numbers are the mesh's; it may be empty.
template <int Dim>
GuideMesh<Dim> restGuide(const SimplicialMesh<Dim>& rest, const std::vector<int>& vertices);

}  // namespace wend
