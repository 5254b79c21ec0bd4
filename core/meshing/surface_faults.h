#pragma once

#include <string>
#include <vector>

#include "core/meshing/surface.h"

namespace wend {

/// One kind of fault of a surface, with the triangles of each case.
struct FaultKind {
    std::string name;  // one word: hole, crossing, crowded_edge, flat, duplicate, turned_edge, missing_vertex
    std::vector<std::vector<int>> cases;
};

/// Returns all kinds that occur, the most serious first. A hole consists of connected open edges.
std::vector<FaultKind> faultsOf(const Surface& surface, const SurfaceProblems& problems);

}  // namespace wend
