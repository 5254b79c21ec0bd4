#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "core/mesh/simplicial_mesh.h"

namespace wend {

struct MeshField;
struct MeshFile;
struct MeshWriteOptions;

// These functions access parts of a mesh file without its header: see mesh_file.h.

/// Reads the mesh of a file, and writes one. Throws InputError.
template <int Dim>
SimplicialMesh<Dim> readMesh(const std::string& path);
template <int Dim>
void writeMesh(const std::string& path, const SimplicialMesh<Dim>& mesh);

/// Returns 3 if the file holds tetrahedra, else 2. Throws InputError.
int dimensionOfMesh(const std::string& path);

/// Returns the extensions that are read and written, in lower case, with the dot.
std::vector<std::string> meshFileExtensions();

/// Returns whether a file of that name may hold vertices without triangles or tetrahedra. Throws InputError
/// for an unknown format.
bool holdsPointsAlone(const std::string& path);

/// Returns these, and the extensions of files that are read only.
std::vector<std::string> readableMeshExtensions();

/// Returns the result of readMeshFile, shared.
std::shared_ptr<const MeshFile> sharedMeshFile(const std::string& path);
/// Numbers per cell or triangle, and the names of the numbers 1, 2, …; either may be empty.
struct NamedLabels {
    std::vector<int> labels;
    std::vector<std::string> names;
};
/// Returns a file of generated cells, with their boundary; `spaces` become the field "ref" and groups.
std::shared_ptr<const MeshFile> madeMeshFile(const SimplicialMesh<3>& mesh,
                                             const std::vector<std::array<int, 3>>& boundary,
                                             const NamedLabels& labels, const NamedLabels& spaces = {});

/// Return the members of a file.
const Eigen::Matrix3Xd& pointsOf(const MeshFile& file);
const std::vector<std::array<int, 3>>& trianglesOf(const MeshFile& file);
const std::vector<std::array<int, 4>>& tetrahedraOf(const MeshFile& file);
const std::vector<int>& labelsOf(const MeshFile& file);
const Eigen::Matrix2Xd& uvOf(const MeshFile& file);
const std::vector<MeshField>& fieldsOf(const MeshFile& file);
/// Returns whether the file contains tetrahedra.
bool isVolume(const MeshFile& file);

/// Returns the partition in a file: triangles in a plane, in its coordinates (see planeOf), or tetrahedra
/// (3D). If cells are numbered in both orientations, all become positive. The result is valid by
/// requireValid, and no two neighbours overlap.
template <int Dim>
SimplicialMesh<Dim> meshFrom(const MeshFile& file);

/// Returns the pairs of neighbours that are on the same side of the facet between them, in a mesh whose cells
/// have one orientation.
template <int Dim>
std::vector<std::array<int, 2>> foldedPairs(const SimplicialMesh<Dim>& mesh);

/// Returns the unit of length of a 3MF file as the file spells it, or "millimeter" if it names none; empty if
/// the file cannot be read.
std::string unitOfThreeMf(const std::string& path);

/// Describes in one line how far single precision moves points that are written with it; empty up to a
/// millionth of their extent.
std::string roundingText(const Eigen::Matrix3Xd& points);

/// Describes in one line what a file of that name would not hold of a mesh that was read, as "2 lines are not
/// in an STL file"; empty if it would hold everything.
std::string lostInFile(const std::string& path, const MeshFile& mesh, const MeshWriteOptions& options);

}  // namespace wend
