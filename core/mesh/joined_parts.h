#pragma once

#include "core/mesh/simplicial_mesh.h"

namespace wend {

/// A mesh whose parts are joined where boundary facets coincide with opposite orientation: many programs
/// write every triangle or texture patch with its own vertices. Points and cell order stay; merged vertices
/// become unused (see twinsOf). A slit, both of whose sides belong to one part, stays open. The mesh must be
/// valid and stays so; if joining would invalidate it, nothing is joined.
template <int Dim>
struct JoinedParts {
    SimplicialMesh<Dim> mesh;
    int vertices = 0;  // joined to others
};
/// Returns the mesh with its parts joined.
template <int Dim>
JoinedParts<Dim> joinedParts(const SimplicialMesh<Dim>& mesh);

}  // namespace wend
