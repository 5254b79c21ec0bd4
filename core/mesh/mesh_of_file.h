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

// The mesh of a file, for users of a part of it: see mesh_file.h.
// Throws InputError.

/// Throws InputError.
template <int Dim>
SimplicialMesh<Dim> readMesh(const std::string& path);
template <int Dim>
void writeMesh(const std::string& path, const SimplicialMesh<Dim>& mesh);

/// 3 if the file holds tetrahedra, 2 otherwise. Throws InputError.
int dimensionOfMesh(const std::string& path);

/// The extensions that are read and written, lower case, with the dot.
std::vector<std::string> meshFileExtensions();

/// Returns whether a file of that name may hold vertices without triangles or tetrahedra. Throws InputError
/// for an unknown format.
bool holdsPointsAlone(const std::string& path);

/// These, and the extensions of files that are read only.
std::vector<std::string> readableMeshExtensions();

/// Returns the result of readMeshFile, shared.
std::shared_ptr<const MeshFile> sharedMeshFile(const std::string& path);
/// A file of cells that were made here, with their boundary.
std::shared_ptr<const MeshFile> madeMeshFile(const SimplicialMesh<3>& mesh,
                                             const std::vector<std::array<int, 3>>& boundary,
                                             const std::vector<int>& labels,
                                             const std::vector<std::string>& labelNames);

const Eigen::Matrix3Xd& pointsOf(const MeshFile& file);
const std::vector<std::array<int, 3>>& trianglesOf(const MeshFile& file);
const std::vector<std::array<int, 4>>& tetrahedraOf(const MeshFile& file);
const std::vector<int>& labelsOf(const MeshFile& file);
const Eigen::Matrix2Xd& uvOf(const MeshFile& file);
const std::vector<MeshField>& fieldsOf(const MeshFile& file);
/// Returns whether the file contains tetrahedra.
bool isVolume(const MeshFile& file);

/// The partition in a file: triangles in a plane, in its coordinates (see planeOf), or tetrahedra (3D). Where
/// cells are numbered in both orientations, all become positive. Validated with requireValid, and no two
/// neighbours overlap.
template <int Dim>
SimplicialMesh<Dim> meshFrom(const MeshFile& file);

/// Neighbours that lie on the same side of the facet between them, in a mesh whose cells are of one
/// orientation.
template <int Dim>
std::vector<std::array<int, 2>> foldedPairs(const SimplicialMesh<Dim>& mesh);

/// How far single precision moves points that are written with it, in one line; empty up to a millionth of
/// their extent.
std::string roundingText(const Eigen::Matrix3Xd& points);

/// What of a mesh that was read would not be in a file of that name, in one line as "2 lines are not in an
/// STL file". Empty if all would be.
std::string lostInFile(const std::string& path, const MeshFile& mesh, const MeshWriteOptions& options);

}  // namespace wend
