#pragma once

#include "core/mesh/mesh_file.h"

namespace wend::formats {

/// Returns for every triangle of a volume's file the tetrahedron that it is a face of (the first of two), or
/// −1 if there is none.
std::vector<int> cellsBehind(const MeshFile& mesh);

/// Returns a generated volume without the triangles of its boundary.
MeshFile withoutBoundary(MeshFile mesh);
/// Returns of a generated mesh the part that its cells use, because solvers find a system singular at other
/// vertices. A mesh that was read is returned unchanged.
MeshFile usedPart(const MeshFile& mesh);

}  // namespace wend::formats
