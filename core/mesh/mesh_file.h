#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/mesh/mesh_field.h"
#include "core/mesh/mesh_of_file.h"
#include "core/mesh/mesh_write_options.h"

namespace wend {

// The readers and writers are Wend's own (formats/, one file per family), not those of a mesh library, for
// three reasons. Vertex and cell order and count must come out as they went in, since materials, handles and
// other programs refer to them by number: libraries merge, renumber or sort. An error must say the line, byte
// or cell: libraries answer "false" or print. And VTK or Gmsh as a library would bring over 1 GB of packages
// for the few record types that are needed. XML and compression are another matter: .vtu goes through pugixml
// and zlib.

/// What a mesh file holds, before a dimension is chosen. Order and count are the file's.
struct MeshFile {
    Eigen::Matrix3Xd points;
    std::vector<std::array<int, 3>> triangles;  // polygons of more corners are split into fans
    std::vector<std::array<int, 4>>
        tetrahedra;       // if there are any, the mesh is a volume and the triangles its boundary
    Eigen::Matrix2Xd uv;  // per vertex; empty if there is none
    std::vector<MeshField> fields;
    std::vector<int> labels;              // of the triangles of a volume's boundary; empty if there are none
    std::vector<std::string> labelNames;  // of the labels 1, 2, …; empty if they have none
    /// The cells were made here, not read: the triangles are the boundary of a volume's tetrahedra, and what
    /// is written has no vertex without a cell.
    bool made = false;
};

/// Reads the formats of meshFileExtensions(). Every index is valid and every coordinate finite in what comes
/// back, but the mesh may still be no partition (see requireValid). Throws InputError(path, place and
/// reason).
///
/// What is not obvious: STL has no vertices; equal points of its facets become one, in the order of their
/// first use. OBJ texture coordinates become one per vertex; where corners of a vertex differ (a seam), the
/// first counts. Tags of cells are the fields "ref" (Medit), "physical" and "entity" (Gmsh), "attribute"
/// (TetGen). Points, lines and data of other kinds are passed over; hexahedra, prisms, pyramids and curved
/// cells are errors.
MeshFile readMeshFile(const std::string& path);

/// Writes to a temporary file beside `path` and renames it: never half-written. Throws InputError on failure.
/// The format is by extension; what a format cannot carry (fields in OBJ, tetrahedra in STL …) is an error
/// for cells and left out for fields and uv. 17 significant digits.
void writeMeshFile(const std::string& path, const MeshFile& mesh, const MeshWriteOptions& options = {});

template <int Dim>
MeshFile toMeshFile(const SimplicialMesh<Dim>& mesh);

}  // namespace wend
