#pragma once

#include <vector>

#include "core/solver/reduced_system.h"

namespace wend {

/// The adjacency of unknowns. The neighbours of i are in [start[i], start[i + 1]), ascending, without i
/// itself.
struct Graph {
    std::vector<int> start, neighbours;

    int size() const { return static_cast<int>(start.size()) - 1; }
};

/// A division of unknowns into groups; `of` has the group of each.
struct Aggregates {
    int count = 0;
    std::vector<int> of;
};

/// Returns the graph in which unknowns that share a cell are neighbours.
template <int Dim>
Graph graphOf(const AssemblyPlan<Dim>& plan, const ReducedSystem<Dim>& system);

/// Returns groups of unknowns. An unknown founds a group with its neighbours if neither it nor any of them is
/// in one yet; each of the others joins the group that most of its neighbours are in. Every unknown is in one
/// group, and the result depends on the graph alone. Time is about linear.
Aggregates aggregatesOf(const Graph& graph);

/// Returns the graph of the groups, in which two are neighbours if members of theirs are.
Graph quotient(const Graph& graph, const Aggregates& aggregates);

}  // namespace wend
