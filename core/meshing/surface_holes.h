#pragma once

#include <vector>

#include "core/meshing/surface.h"

namespace wend {

/// Returns the boundaries of the holes as loops of vertices, in the direction in which triangles that fill
/// them run; no loop passes a vertex twice. If several holes meet at a vertex, each has its own loop. The
/// triangles must be oriented consistently.
std::vector<std::vector<int>> holeLoops(const Surface& surface);

/// Returns the loops that can be filled: the boundary of a triangle connected by one vertex only looks like a
/// hole, too.
std::vector<std::vector<int>> holesOf(const Surface& surface);

/// Returns the triangle beside the longest side of a loop that is only a slit: where a vertex is on an edge
/// without belonging to it, a filling would have no area. Without that triangle the hole can be filled.
/// Returns −1 if it is no slit.
int besideSlit(const Surface& surface, const std::vector<int>& loop);

/// Closes a hole along its loop: a triangle, or a fan around the centre of the boundary.
void fillHole(Surface& surface, const std::vector<int>& loop, int label = 0);

/// The result of fillHoles().
struct FilledHoles {
    int holes = 0, triangles = 0;  // the last of the surface
    std::vector<int> larger;       // the numbers of edges of those that stayed
};

/// Fills holes of at most `largest` edges, and slits together with the triangle beside them.
FilledHoles fillHoles(Surface& surface, int largest);

}  // namespace wend
