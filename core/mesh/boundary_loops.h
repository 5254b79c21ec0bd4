#pragma once

#include <vector>

#include "core/mesh/simplicial_mesh.h"

namespace wend {

/// The closed polygons that bound a part of the plane, each in the direction in which the cells run along it.
/// Where several meet in a vertex, each goes on as it happens to: together they enclose the same.
std::vector<std::vector<Vec<2>>> boundaryLoops(const SimplicialMesh<2>& mesh);

}  // namespace wend
