#pragma once

/// @file
/// Meshes: triangles in the plane and tetrahedra in space, read, written and made.

#include <array>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "wend/error.h"

namespace wend {

/// A point or a vector: x and y in the plane, x, y and z in space.
template <int Dim>
using Coordinates = std::array<double, Dim>;

/// The Dim + 1 vertices of a cell, a triangle or a tetrahedron, counted from 0.
template <int Dim>
using CellVertices = std::array<int, Dim + 1>;

/// Cells over vertices. All cells have the same orientation; every facet has one or two of them.
template <int Dim>
struct Mesh {
    std::vector<Coordinates<Dim>> points = {};  ///< Of the vertices, in any unit of length.
    std::vector<CellVertices<Dim>> cells = {};  ///< Triangles or tetrahedra.
};

/// Returns 3 if a file holds tetrahedra, and 2 otherwise.
/// @throws InvalidInput with the name of the file.
WEND_API int meshDimension(const std::string& path);

/// Reads a mesh: OBJ, PLY, OFF, STL, Medit .mesh, Gmsh .msh, TetGen .node, VTK .vtk and .vtu, Abaqus .inp,
/// Nastran .bdf and others. Order and count of the vertices are the file's; cells of more corners are split.
/// In the plane z is constant and left out.
/// @throws InvalidInput with the name of the file, and the line, vertex or cell.
template <int Dim>
Mesh<Dim> loadMesh(const std::string& path);

/// Writes a mesh, whole or not at all, with 17 significant digits; the extension decides the format.
/// @throws InvalidInput if the format does not hold such cells, or the file cannot be written.
template <int Dim>
void saveMesh(const std::string& path, const Mesh<Dim>& mesh);

/// How meshPolygons() meshes.
struct PolygonMeshing {
    int vertices = 5000;   ///< Number of vertices that is aimed at, met within 10 %.
    double edge = 0;       ///< If greater than 0, the mean length of edges that is aimed at.
    double minAngle = 25;  ///< In degrees, 0 to 30; sharper corners of the polygons stay.
    std::vector<Coordinates<2>> points = {};  ///< Become vertices: point i is vertex i, to the last bit.
    std::stop_token stop = {};                ///< Ends the call.
};

/// Triangles inside closed polygons, by constrained Delaunay refinement. A point is inside if an odd number
/// of polygons encloses it: an outer one, holes, islands in holes.
/// @throws InvalidInput for polygons that cross or have no area, and points outside; Interrupted.
WEND_API Mesh<2> meshPolygons(const std::vector<std::vector<Coordinates<2>>>& polygons,
                              const PolygonMeshing& options = {});

/// How fillSurface() meshes.
struct SurfaceFilling {
    int vertices = 0;           ///< If greater than 0, the number of vertices that is aimed at.
    double maxVolume = 0;       ///< If greater than 0 and `vertices` is 0, the largest volume of a cell.
    double quality = 1.414;     ///< The largest radius–edge ratio of a cell, 1.2 or more.
    bool keepSurface = true;    ///< The surface's vertices come first, unchanged, and its triangles stay.
    std::stop_token stop = {};  ///< Ends the call.
};

/// Tetrahedra inside a closed surface of triangles, by TetGen in a process of its own.
/// @throws InvalidInput with all that is wrong with a surface that bounds no volume; Interrupted.
WEND_API Mesh<3> fillSurface(std::span<const Coordinates<3>> points,
                             std::span<const std::array<int, 3>> triangles,
                             const SurfaceFilling& options = {});

/// @cond
extern template WEND_API Mesh<2> loadMesh<2>(const std::string&);
extern template WEND_API Mesh<3> loadMesh<3>(const std::string&);
extern template WEND_API void saveMesh<2>(const std::string&, const Mesh<2>&);
extern template WEND_API void saveMesh<3>(const std::string&, const Mesh<3>&);
/// @endcond

}  // namespace wend
