#pragma once

#include <string>
#include <vector>

#include "core/mesh/simplicial_mesh.h"

namespace wend {

/// A field of a mesh file: `components` numbers per vertex or per cell.
struct MeshField {
    std::string name;
    bool perCell = false;
    int components = 1;
    std::vector<double> values;
};

/// What a mesh file holds, before a dimension is chosen. Order and count are the file's.
struct MeshFile {
    Eigen::Matrix3Xd points;
    std::vector<std::array<int, 3>> triangles;   // polygons of more corners are split into fans
    std::vector<std::array<int, 4>> tetrahedra;  // if there are any, the mesh is a volume
    Eigen::Matrix2Xd uv;                         // per vertex; empty if there is none
    std::vector<MeshField> fields;
};

/// Formats by extension: .obj .ply .off .stl .mesh .msh (2.2 and 4.1, text and binary) .node/.ele .vtk .vtu.
/// Throws InputError(path, what and line).
MeshFile readMeshFile(const std::string& path);

/// Writes to a temporary file beside `path` and renames it: never half-written. Throws InputError on failure.
/// The format is by extension; what a format cannot carry (fields in OBJ, tetrahedra in STL …) is an error
/// for cells and left out for fields and uv. 17 significant digits.
void writeMeshFile(const std::string& path, const MeshFile& mesh);

/// The partition in a file: triangles in the plane z = constant, or tetrahedra (3D). Validated with
/// requireValid.
template <int Dim>
SimplicialMesh<Dim> meshFrom(const MeshFile& file);
template <int Dim>
MeshFile toMeshFile(const SimplicialMesh<Dim>& mesh);

/// True if the file holds tetrahedra.
bool isVolume(const MeshFile& file);

}  // namespace wend
