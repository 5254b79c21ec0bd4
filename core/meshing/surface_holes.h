#pragma once

#include <vector>

#include "core/meshing/surface.h"

namespace wend {

/// The boundaries of the holes as loops of vertices, in the direction in which triangles that fill them run;
/// no loop passes a vertex twice. Where several holes meet at a vertex, each has its own loop. The triangles
/// must be oriented consistently.
std::vector<std::vector<int>> holeLoops(const Surface& surface);

/// Closes holes of at most `largest` edges: a triangle, or a fan around the centre of the boundary. Returns
/// how many were closed; `larger` gets the numbers of edges of those that were not.
int fillHoles(Surface& surface, int largest, std::vector<int>& larger);

}  // namespace wend
