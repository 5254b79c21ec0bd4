#pragma once

#include <memory>
#include <vector>

#include "core/assembly/assembly_plan.h"
#include "core/energy/material.h"
#include "core/solver/reduced_system.h"

namespace wend {

/// Another part that has copies of some unknowns of a part, or has unknowns of which that has copies.
struct Neighbour {
    int part;
    std::vector<int> sent;          // own unknowns that the other part copies, in the other's order
    int firstCopy = 0, copies = 0;  // the unknowns that are copied from there
};

/// The share of one process in a system K = Zᵀ A Z: the cells that contribute to its own rows of K, as a mesh
/// of their own. Its vertices have new numbers: its own unknowns come first, then copies of other parts'
/// unknowns, part by part, then the vertices that follow from unknowns or are prescribed.
template <int Dim>
struct Part {
    int number = 0, own = 0, copies = 0;
    std::vector<int> unknowns;         // of its own: their numbers in the whole system
    std::vector<int> vertices, cells;  // their numbers in the whole mesh
    std::vector<Cell<Dim>> corners;    // of the cells
    std::vector<Neighbour> neighbours;
    std::vector<int> followers;  // vertices that are no unknowns and count for this part alone
    Elimination elimination;     // of its vertices, without what is prescribed
    Sliders sliders;
};

/// A graph in the form of MatCreateMPIAdj(): neighbours of every node ascending, with the weights of edges
/// and nodes.
struct WeightedGraph {
    std::vector<int> start{0}, neighbour, edgeWeight, nodeWeight;
    int nodes() const { return static_cast<int>(nodeWeight.size()); }
};

/// Returns the graph of the groups of vertices, with edges where cells connect them; `groupOf` has a group
/// for every vertex, or −1.
template <int Dim>
WeightedGraph groupGraph(const AssemblyPlan<Dim>& plan, const std::vector<int>& groupOf, int groups);

/// Divides a system. `ownerOf` has a part for every vertex that is an unknown of the system.
template <int Dim>
class Division {
  public:
    Division(const AssemblyPlan<Dim>& plan, const ReducedSystem<Dim>& system, std::vector<int> ownerOf,
             int parts);

    int parts() const { return m_parts; }
    /// Returns a part without the lists of what its neighbours copy from it.
    Part<Dim> part(int number) const;

  private:
    std::vector<int> rowsOf(int number) const;
    void addCellsOf(int vertex, std::vector<char>& hasCell, std::vector<int>& cells) const;
    void close(std::vector<char>& hasCell, std::vector<int>& cells) const;
    void number(int number, const std::vector<char>& hasVertex, Part<Dim>& part) const;
    void copyConstraints(const std::vector<int>& local, Part<Dim>& part) const;
    bool isUnknown(int vertex) const { return m_ownerOf[vertex] >= 0; }
    int homeOf(std::size_t pivot) const;

    const AssemblyPlan<Dim>& m_plan;
    const ReducedSystem<Dim>& m_system;
    std::vector<int> m_ownerOf, m_pivotOf;  // per vertex, −1: none
    std::vector<int> m_homeOf;              // per pivot: the part for which it counts
    int m_parts;
};

/// Returns all parts of a division, each with all of its neighbours.
template <int Dim>
std::vector<Part<Dim>> allParts(const Division<Dim>& division);

/// Returns the values of a vector over the vertices of the whole mesh at those of a part.
template <int Dim>
Points<Dim> gathered(const Points<Dim>& whole, const std::vector<int>& vertices);

}  // namespace wend
