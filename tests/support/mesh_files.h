#pragma once

#include <string>
#include <vector>

#include "core/mesh/mesh_field.h"
#include "core/mesh/mesh_of_file.h"
#include "core/meshing/surface.h"

namespace wend::test {

/// Triangles, in space or flat, with texture points if there are any.
void writeSurface(const std::string& path, const Surface& surface, const Eigen::Matrix2Xd& uv = {});
void writeSolid(const std::string& path, const SimplicialMesh<3>& mesh,
                const std::vector<MeshField>& fields = {});
const std::vector<std::string>& labelNamesOf(const MeshFile& file);
/// A flat mesh as a surface in space.
Surface surfaceOf(const SimplicialMesh<2>& mesh);

}  // namespace wend::test
