#pragma once

#include "core/mesh/mesh_file.h"

namespace wend::formats {

/// For every triangle of a volume's file the tetrahedron that it is a face of (of two, the first), −1 where
/// there is none.
std::vector<int> cellsBehind(const MeshFile& mesh);

/// A volume that was made, without the triangles of its boundary.
MeshFile withoutBoundary(MeshFile mesh);
/// Of a mesh that was made, what its cells use: solvers find a system singular at other vertices. A mesh that
/// was read stays as it is.
MeshFile usedPart(const MeshFile& mesh);

}  // namespace wend::formats
