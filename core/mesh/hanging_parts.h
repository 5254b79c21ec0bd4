#pragma once

#include <array>
#include <vector>

#include "core/mesh/simplicial_mesh.h"

namespace wend {

/// A part that is connected to others by a vertex, or in space by a line only: it rotates freely there and
/// may move far if nothing holds it.
struct HangingPart {
    std::vector<int> joint;  // vertices, increasing
    int cells = 0, firstCell = 0;
};

/// Returns such parts in the order of their first cells; the largest of touching parts counts as the base.
template <int Dim>
std::vector<HangingPart> hangingParts(const SimplicialMesh<Dim>& mesh);

/// Returns such parts of the volume enclosed by a surface: triangles are connected by edges of two.
std::vector<HangingPart> hangingParts(const Points3& points,
                                      const std::vector<std::array<int, 3>>& triangles);

}  // namespace wend
