#pragma once

#include "core/mesh/simplicial_mesh.h"

namespace wend {

/// A mesh whose parts are connected where their boundaries lie on each other, facet on facet and vertex on
/// vertex, from both sides: many programs write every triangle, or every patch of a texture, with vertices of
/// its own. Points and the order of cells stay; vertices that were joined to others have no cell any more
/// (see twinsOf). A slit, whose two sides belong to one part, stays open. The mesh must be valid, and is
/// again; where joining would spoil it, nothing is joined.
template <int Dim>
struct JoinedParts {
    SimplicialMesh<Dim> mesh;
    int vertices = 0;  // joined to others
};
template <int Dim>
JoinedParts<Dim> joinedParts(const SimplicialMesh<Dim>& mesh);

}  // namespace wend
