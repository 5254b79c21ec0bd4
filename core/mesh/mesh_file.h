#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "core/mesh/cell_list.h"
#include "core/mesh/mesh_field.h"
#include "core/mesh/mesh_needs.h"
#include "core/mesh/mesh_of_file.h"
#include "core/mesh/mesh_write_options.h"

namespace wend {

// The readers and writers are Wend's own (formats/, one file per family), for three reasons. The order and
// number of vertices and cells must be preserved, because materials, handles and other programs refer to them
// by number: libraries merge, renumber or sort. An error must name the line, byte or cell: libraries return
// "false" or print. And VTK or Gmsh would add over 1 GB of packages for the few record types that are needed.
// XML and compression are different: .vtu uses pugixml and zlib.

/// The highest label that has a name: names are a list, and no file shall make it a long one.
constexpr long kHighestLabel = 100000;

/// The content of a mesh file, before a dimension is chosen. Order and count are the file's. Bending changes
/// points only; everything else is written as it was read, as far as the output format holds it.
struct MeshFile {
    Eigen::Matrix3Xd points;
    std::vector<std::array<int, 3>> triangles;   // what the cells of the plane were split into
    std::vector<std::array<int, 4>> tetrahedra;  // what the cells of space were split into; if there are any,
                                                 // the mesh is a volume and the triangles its boundary
    Eigen::Matrix2Xd uv;                         // per vertex; empty if there is none
    /// u and v of every node of every cell (as many pairs as `cells` has nodes, NaN where there is none), if
    /// `uv` cannot represent them: corners of a vertex differ, or some have none. Empty otherwise.
    std::vector<double> cornerUv;
    std::vector<MeshField> fields;
    std::vector<int> labels;              // of the triangles of a volume's boundary; empty if there are none
    std::vector<std::string> labelNames;  // of the labels 1, 2, …; empty if they have none

    /// All cells of the file, of every dimension; none if the cells were generated here.
    CellList cells;
    std::vector<int> cellOfTriangle, cellOfTetrahedron;  // which of `cells` each was split from
    std::vector<MeshGroup> groups;
    std::vector<MeshField> fileFields;  // of the file as a whole
    int polyhedra = 0;  // of the file, which tetrahedra around a vertex within stand for in `cells`
    std::vector<std::string> notices;  // what was in the file and is not in here, each as "its 3 cameras"
    /// The bytes of a file whose format holds far more than a mesh (Abaqus, Nastran): written in the same
    /// format, it is this file with other points. `deckFormat` is its first extension.
    std::shared_ptr<const std::string> deck;
    std::string deckFormat;
    int firstNumber = 1;  // of the vertices, where a format leaves the choice (TetGen)
    /// True if the cells were generated, not read: the triangles are the boundary of a volume's tetrahedra,
    /// and files have no vertex without a cell.
    bool made = false;
    std::vector<std::string> spaceNames;  // of the values 1, 2, … of the field "ref" of generated cells

    /// Returns whether there are texture coordinates of corners for the cells as they are.
    bool hasCornerUv() const { return !cornerUv.empty() && cornerUv.size() == 2 * cells.nodes.size(); }
};

/// Reads the formats of meshFileExtensions(). Every index is valid and every coordinate finite in what comes
/// back, but the mesh may still be no partition (see requireValid). Throws InputError(path, place and
/// reason).
///
/// What is not obvious: STL has no vertices; equal points of its facets become one, in the order of their
/// first use. Texture coordinates of corners become one per vertex, the first one; where corners of a vertex
/// differ (a seam), all are in `cornerUv`. Tags of cells are groups and the fields "ref" (Medit), "physical"
/// and "entity" (Gmsh), "attribute" (TetGen). Polygons, hexahedra, wedges and pyramids are split inside (see
/// finishCells); nodes between the corners of a cell belong to no triangle or tetrahedron. Polyhedra of
/// OpenFOAM become tetrahedra around vertices behind the file's own; elsewhere they are errors.
MeshFile readMeshFile(const std::string& path, MeshNeeds needs = MeshNeeds::Cells);

/// Writes to a temporary file beside `path` and renames it, so that no partial file remains. Throws
/// InputError on failure. The extension decides the format; cells that it cannot hold (tetrahedra in STL …)
/// are an error, fields and uv are left out. Numbers have 17 significant digits.
void writeMeshFile(const std::string& path, const MeshFile& mesh, const MeshWriteOptions& options = {});

/// Returns a mesh as the content of a file, in the same order and units, without fields, groups and a list of
/// cells: planar points (2 × n) get z = 0; cells become `triangles` in 2D and `tetrahedra` in 3D, whose
/// boundary is not listed. Parts and welds are left out.
template <int Dim>
MeshFile toMeshFile(const SimplicialMesh<Dim>& mesh);

}  // namespace wend
