#pragma once

#include <array>
#include <vector>

#include "core/mesh/simplicial_mesh.h"

namespace wend {

/// A part that hangs on the others by a vertex, or in space along a line, only: it turns freely there, and
/// what nothing holds may be flung far away.
struct HangingPart {
    std::vector<int> joint;  // vertices, increasing
    int cells = 0, firstCell = 0;
};

/// Of parts that touch, the largest counts as what the others hang on. In the order of their first
/// cells.
template <int Dim>
std::vector<HangingPart> hangingParts(const SimplicialMesh<Dim>& mesh);

/// The same of what a surface in space encloses: triangles are connected by edges of two.
std::vector<HangingPart> hangingParts(const Points<3>& points,
                                      const std::vector<std::array<int, 3>>& triangles);

}  // namespace wend
