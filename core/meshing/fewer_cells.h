#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/mesh/point_locator.h"

namespace wend {

/// Cells of fewer vertices that take up the same place as a mesh.
struct FewerCells {
    std::vector<Cell<2>> cells;   // of the mesh's own vertices
    std::vector<int> cellInMesh;  // of each the mesh's cell at its centroid
};

/// The constrained Delaunay triangulation of some of a mesh's vertices; edges of the mesh are kept, those of
/// its boundary among them. `located`: the mesh's cells. Nothing where it covers itself at rest.
std::optional<FewerCells> fewerCells(const SimplicialMesh<2>& mesh, const PointLocator<2>& located,
                                     const std::vector<int>& vertices,
                                     const std::vector<std::array<int, 2>>& edges);

}  // namespace wend
