#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/mesh/mesh_field.h"
#include "core/mesh/mesh_of_file.h"
#include "core/mesh/mesh_write_options.h"

namespace wend {

// The readers and writers are Wend's own (formats/, one file per family), for three reasons. The order and
// number of vertices and cells must be preserved, because materials, handles and other programs refer to them
// by number: libraries merge, renumber or sort. An error must name the line, byte or cell: libraries return
// "false" or print. And VTK or Gmsh would add over 1 GB of packages for the few record types that are needed.
// XML and compression are different: .vtu uses pugixml and zlib.

/// The content of a mesh file before a dimension is chosen, in the file's order.
struct MeshFile {
    Eigen::Matrix3Xd points;
    std::vector<std::array<int, 3>> triangles;  // polygons of more corners are split into fans
    std::vector<std::array<int, 4>>
        tetrahedra;       // if there are any, the mesh is a volume and the triangles its boundary
    Eigen::Matrix2Xd uv;  // per vertex; empty for none
    std::vector<MeshField> fields;
    std::vector<int> labels;              // of the triangles of a volume's boundary; empty if there are none
    std::vector<std::string> labelNames;  // of the labels 1, 2, …; empty if they have none
    /// The cells were generated, not read: the triangles are the boundary of the tetrahedra, and unused
    /// vertices are not written.
    bool made = false;
};

/// Reads the formats of meshFileExtensions(). All indices are valid and all coordinates finite, but the mesh
/// need not be a partition (see requireValid). Throws InputError(path, place and reason).
/// Conventions: STL has no vertices; equal points of its facets become one, in order of their first use. OBJ
/// texture coordinates become one per vertex; at a seam, the first corner counts. Cell tags are the fields
/// "ref" (Medit), "physical" and "entity" (Gmsh), "attribute" (TetGen). Points, lines and other data are
/// skipped; hexahedra, prisms, pyramids and curved cells are errors.
MeshFile readMeshFile(const std::string& path);

/// Writes to a temporary file beside `path` and renames it, so that no partial file remains. Throws
/// InputError on failure. The extension decides the format; cells that it cannot hold (tetrahedra in STL …)
/// are an error, fields and uv are left out. Numbers have 17 significant digits.
void writeMeshFile(const std::string& path, const MeshFile& mesh, const MeshWriteOptions& options = {});

/// Returns a mesh as the content of a file, in the same order and units, without fields: planar points (2 ×
/// n) get z = 0; cells become `triangles` in 2D and `tetrahedra` in 3D.
template <int Dim>
MeshFile toMeshFile(const SimplicialMesh<Dim>& mesh);

}  // namespace wend
