#pragma once

#include "core/mesh/types.h"

namespace wend {

struct MeshFile;

/// Turns the normals of vertices that are fields of a file (nx, ny, nz, or three components of a name with
/// "normal") as its triangles turned from `before` to their present points: by the smallest rotation between
/// the surface's own normals there. Where nothing moves, they keep their bits.
void turnNormals(const Points<3>& before, MeshFile& file);

}  // namespace wend
