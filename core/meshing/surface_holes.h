#pragma once

#include <vector>

#include "core/meshing/surface.h"

namespace wend {

/// The boundaries of the holes as loops of vertices, in the direction in which triangles that fill them run;
/// no loop passes a vertex twice. Where several holes meet at a vertex, each has its own loop. The triangles
/// must be oriented consistently.
std::vector<std::vector<int>> holeLoops(const Surface& surface);

/// Those of them that can be filled: a triangle that hangs at one vertex only has the same boundary as a
/// hole.
std::vector<std::vector<int>> holesOf(const Surface& surface);

/// Closes a hole along its loop: a triangle, or a fan around the centre of the boundary.
void fillHole(Surface& surface, const std::vector<int>& loop);

/// Closes holes of at most `largest` edges. Returns how many were closed; `larger` gets the numbers of edges
/// of those that were not.
int fillHoles(Surface& surface, int largest, std::vector<int>& larger);

}  // namespace wend
