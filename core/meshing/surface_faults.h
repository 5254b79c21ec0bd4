#pragma once

#include <string>
#include <vector>

#include "core/meshing/surface.h"

namespace wend {

/// One kind of what is wrong with a surface, and the triangles of each case of it.
struct FaultKind {
    std::string name;  // one word: hole, crossing, crowded_edge, flat, duplicate, turned_edge, missing_vertex
    std::vector<std::vector<int>> cases;
};

/// All kinds that there are, the gravest first. A hole is all open edges that are connected.
std::vector<FaultKind> faultsOf(const Surface& surface, const SurfaceProblems& problems);

}  // namespace wend
