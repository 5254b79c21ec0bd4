#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/mesh/point_locator.h"

namespace wend {

/// Cells with fewer vertices that cover the same area as a mesh.
struct FewerCells {
    std::vector<Cell<2>> cells;   // of the mesh's own vertices
    std::vector<int> cellInMesh;  // of each the mesh's cell at its centroid
};

/// Computes the constrained Delaunay triangulation of some of a mesh's vertices; the mesh's edges between
/// them are kept, including its boundary. `located`: the mesh's cells. Returns nothing if it overlaps itself
/// at rest.
std::optional<FewerCells> fewerCells(const SimplicialMesh<2>& mesh, const PointLocator<2>& located,
                                     const std::vector<int>& vertices,
                                     const std::vector<std::array<int, 2>>& edges);

}  // namespace wend
