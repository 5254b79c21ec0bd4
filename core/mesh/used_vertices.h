#pragma once

#include <vector>

#include "core/mesh/simplicial_mesh.h"

namespace wend {

/// Returns which vertices belong to a cell. Files may contain unused vertices, such as duplicates or
/// leftovers of an editor; they are not part of the shape and do not extend its bounding box. Twins (below)
/// follow a used vertex. Vertex indices of the cells must be valid.
template <int Dim>
std::vector<bool> usedVertices(Eigen::Index vertexCount, const std::vector<Cell<Dim>>& cells);

/// An unused vertex at the place of a used one, which it follows. Surfaces and seams are often written with
/// separate vertices per triangle or patch.
struct Twin {
    int vertex, of;
};
/// Returns the twins, in the order of their vertices; of several candidates the first is followed.
/// Coordinates must be equal exactly, but −0 equals 0. There are none if every vertex is used.
template <int Dim>
std::vector<Twin> twinsOf(const SimplicialMesh<Dim>& mesh);
/// Moves every twin to the place of its vertex: points.col(vertex) = points.col(of), for any field of one
/// column per vertex (Dim × n), such as a pose or a velocity field. A used vertex is never a twin, so the
/// order of twins does not matter.
template <int Dim>
void takeAlong(const std::vector<Twin>& twins, Points<Dim>& points);

/// Returns for each vertex the first one at the same place (itself if there is none before it). It takes O(n
/// log n) comparisons of coordinates.
template <int Dim>
std::vector<int> firstAtPlace(const Points<Dim>& points);

/// An axis-aligned box.
template <int Dim>
struct Extent {
    Vec<Dim> low = Vec<Dim>::Zero(), high = Vec<Dim>::Zero();

    Vec<Dim> centre() const { return (low + high) / 2; }
    double diagonal() const { return (high - low).norm(); }
};

/// Returns the box around the vertices that cells have; a point at the origin if there are no cells.
template <int Dim>
Extent<Dim> extentOf(const Points<Dim>& points, const std::vector<Cell<Dim>>& cells);

}  // namespace wend
