#pragma once

#include <string>
#include <vector>

#include "core/base/message.h"
#include "core/mesh/simplicial_mesh.h"
#include "core/meshing/surface.h"

namespace wend {

/// Compares the shape of the generated cells with the requested quality.
struct MeshVerdict {
    double asked = 0, got = 0;  // maximum ratio of circumradius to shortest edge
    int worstCell = -1;
    int cellsAbove = 0;
    /// Triangles of a kept surface at an edge or corner of these cells, which force their shape; worst cells
    /// first.
    std::vector<int> facets;

    bool missed() const { return cellsAbove > 0; }
    /// Returns one line; empty for moderate deviations: up to eight times the ratio is common along a
    /// surface.
    Message text() const;
};

MeshVerdict verdictOn(const SimplicialMesh<3>& mesh, const Surface& surface, double asked, bool kept);

}  // namespace wend
