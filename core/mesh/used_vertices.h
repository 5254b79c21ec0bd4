#pragma once

#include <vector>

#include "core/mesh/simplicial_mesh.h"

namespace wend {

/// Files may hold vertices that no cell has: spare copies of a corner, leftovers of an editor. They belong to
/// no shape; nothing holds on to them and they stretch no bounding box. Twins (below) go along with it.
template <int Dim>
std::vector<bool> usedVertices(Eigen::Index vertexCount, const std::vector<Cell<Dim>>& cells);

/// A vertex that no cell has, at the place of one that a cell has: it goes where that one goes. Surfaces and
/// seams are often written with vertices of their own for every triangle or patch.
struct Twin {
    int vertex, of;
};
/// Of several candidates a twin goes with the first.
template <int Dim>
std::vector<Twin> twinsOf(const SimplicialMesh<Dim>& mesh);
template <int Dim>
void takeAlong(const std::vector<Twin>& twins, Points<Dim>& points);

/// For each vertex the first one at the same place (itself, if there is none before it).
template <int Dim>
std::vector<int> firstAtPlace(const Points<Dim>& points);

/// An axis-aligned box.
template <int Dim>
struct Extent {
    Vec<Dim> low = Vec<Dim>::Zero(), high = Vec<Dim>::Zero();

    Vec<Dim> centre() const { return (low + high) / 2; }
    double diagonal() const { return (high - low).norm(); }
};

/// The box around the vertices that cells have; a point at the origin without cells.
template <int Dim>
Extent<Dim> extentOf(const Points<Dim>& points, const std::vector<Cell<Dim>>& cells);

}  // namespace wend
