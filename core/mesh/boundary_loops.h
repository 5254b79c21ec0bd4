#pragma once

#include <vector>

#include "core/mesh/simplicial_mesh.h"

namespace wend {

/// Returns the closed polygons that bound a planar mesh, oriented along the cells. Where several meet at a
/// vertex, their pairing is arbitrary: together they enclose the same area. The outside is on the right of
/// every edge for cells of positive orientation, so holes run clockwise. The first point is not repeated at
/// the end. Throws InputError as facetsOf() does.
std::vector<std::vector<Vec2>> boundaryLoops(const SimplicialMesh<2>& mesh);

}  // namespace wend
