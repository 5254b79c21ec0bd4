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

/// The triangle beside the longest side of a loop that is no more than a slit: where a vertex lies on an edge
/// that knows nothing of it, what would fill the hole has no area. With that triangle gone the hole can be
/// filled. −1 if it is no slit.
int besideSlit(const Surface& surface, const std::vector<int>& loop);

/// Closes a hole along its loop: a triangle, or a fan around the centre of the boundary.
void fillHole(Surface& surface, const std::vector<int>& loop, int label = 0);

struct FilledHoles {
    int holes = 0, triangles = 0;  // the last of the surface
    std::vector<int> larger;       // the numbers of edges of those that stayed
};

/// Closes holes of at most `largest` edges, slits with the triangle beside them made anew.
FilledHoles fillHoles(Surface& surface, int largest);

}  // namespace wend
