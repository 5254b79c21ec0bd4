#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/base/types.h"

namespace wend {

/// Consecutive vertices and cells of a partition, under a name. Parts share no vertex.
struct MeshPart {
    std::string name;
    int firstVertex = 0, endVertex = 0;
    int firstCell = 0, endCell = 0;
    bool operator==(const MeshPart&) const = default;
};

/// Two points of a partition at one place, which stay together: Σ weight · x_vertex = 0. The weights of one
/// point sum to 1, those of the other to −1.
struct Weld {
    std::vector<std::pair<int, double>> terms;
    bool operator==(const Weld&) const = default;
};

/// A partition: triangles in the plane (Dim 2) or tetrahedra in space (Dim 3). Vertex and cell order are the
/// input's.
template <int Dim>
struct SimplicialMesh {
    Points<Dim> points;
    std::vector<Cell<Dim>> cells;
    std::vector<MeshPart> parts =
        {};  // all vertices and cells, from back to front; empty: one without a name
    std::vector<Weld> welds = {};

    int vertexCount() const { return static_cast<int>(points.cols()); }
    int cellCount() const { return static_cast<int>(cells.size()); }
};

/// Returns the signed area or volume of a cell, det[x1 − x0, …] / Dim!. Its unit is that of the points to the
/// power of Dim; 0 for a flat cell up to rounding.
template <int Dim>
double cellMeasure(const Points<Dim>& points, const Cell<Dim>& cell);

/// Returns the length of the diagonal of the axis-aligned bounding box.
template <int Dim>
double boundingBoxDiagonal(const Points<Dim>& points);

/// An edge (2D) or triangle (3D) of the partition; cells[1] is −1 on the boundary. On a boundary facet the
/// vertices run as in its cell, so that its outer side is consistent.
template <int Dim>
struct Facet {
    std::array<int, Dim> vertices;
    std::array<int, 2> cells;

    bool interior() const { return cells[1] >= 0; }
};

/// Returns all facets in the order of the cells that contribute them. Throws InputError naming the cells if
/// more than two share one. cells[0] is the cell of the lower number. Vertex indices must be valid. Time is
/// linear as a rule, also where many cells share a vertex.
template <int Dim>
std::vector<Facet<Dim>> facetsOf(const SimplicialMesh<Dim>& mesh);

/// Throws InputError that names vertex or cell for: no cell; NaN or infinite coordinates; an index out of
/// range; a repeated vertex in a cell; a flat cell (see isFlat); a duplicate cell; cells of both
/// orientations, of which the rarer ones count as inverted; a facet of more than two cells. The checks run in
/// this order, and the first finding is thrown. All cells of negative orientation are accepted; parts and
/// welds are not looked at.
template <int Dim>
void requireValid(const SimplicialMesh<Dim>& mesh);

}  // namespace wend
