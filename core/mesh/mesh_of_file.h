#pragma once

#include <string>

#include "core/mesh/simplicial_mesh.h"

namespace wend {

// The mesh of a file for who needs nothing else of it: see mesh_file.h.

/// Throws InputError.
template <int Dim>
SimplicialMesh<Dim> readMesh(const std::string& path);
template <int Dim>
void writeMesh(const std::string& path, const SimplicialMesh<Dim>& mesh);

/// 3 if the file holds tetrahedra, 2 otherwise. Throws InputError.
int dimensionOfMesh(const std::string& path);

}  // namespace wend
