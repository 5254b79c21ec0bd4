#pragma once

#include <string>
#include <vector>

#include "core/mesh/simplicial_mesh.h"
#include "core/meshing/surface.h"

namespace wend {

/// Whether the cells that a surface was filled with are as round as was asked for.
struct MeshVerdict {
    double asked = 0, got = 0;  // maximum ratio of circumradius to shortest edge
    int worstCell = -1;
    int cellsAbove = 0;
    /// Triangles of the surface, if it was kept, at an edge or else a corner of these cells: the cells cannot
    /// be other than they ask for. Those of the worst cells first.
    std::vector<int> facets;

    bool missed() const { return cellsAbove > 0; }
    /// One line; empty where little is missing: up to eight times the ratio is usual along a surface.
    std::string text() const;
};

MeshVerdict verdictOn(const SimplicialMesh<3>& mesh, const Surface& surface, double asked, bool kept);

}  // namespace wend
