#pragma once

#include <vector>

#include "app/mpi/division.h"

namespace wend {

/// Divides the nodes of a graph into parts of nearly equal weight with few edges between them, by PT-Scotch
/// through PETSc: the part of every node. Throws std::runtime_error.
std::vector<int> partitionOf(const WeightedGraph& graph, int parts);

}  // namespace wend
