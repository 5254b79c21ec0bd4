#pragma once

#include "core/mesh/mesh_file.h"

namespace wend::formats {

/// For every triangle of a volume's file the tetrahedron that it is a face of (of two, the first), −1 where
/// there is none.
std::vector<int> cellsBehind(const MeshFile& mesh);

/// What a field per cell is on the triangles of a volume's boundary: the values of the cells behind them, so
/// that a face looks like its cell; NaN without one.
std::vector<double> boundaryValues(const MeshField& field, const std::vector<int>& cellsBehind);

/// The volume with the triangles of its boundary, which must have none.
MeshFile withBoundary(MeshFile mesh);
MeshFile withoutBoundary(MeshFile mesh);
/// Of a mesh that was made, what its cells use: solvers find a system singular at other vertices. A mesh that
/// was read stays as it is.
MeshFile usedPart(const MeshFile& mesh);

}  // namespace wend::formats
