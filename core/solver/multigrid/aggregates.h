#pragma once

#include <vector>

#include "core/solver/reduced_system.h"

namespace wend {

/// Which unknowns are next to each other: neighbours in [start[i], start[i + 1]), ascending, not i itself.
struct Graph {
    std::vector<int> start, neighbours;

    int size() const { return static_cast<int>(start.size()) - 1; }
};

/// Groups of unknowns: of each its group.
struct Aggregates {
    int count = 0;
    std::vector<int> of;
};

/// Unknowns that share a cell.
template <int Dim>
Graph graphOf(const AssemblyPlan<Dim>& plan, const ReducedSystem<Dim>& system);

/// An unknown and all around it, as many such groups as come one after the other; the other unknowns join
/// the one that they have most to do with.
Aggregates aggregatesOf(const Graph& graph);

/// Groups are next to each other if members are.
Graph quotient(const Graph& graph, const Aggregates& aggregates);

}  // namespace wend
