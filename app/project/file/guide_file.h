#pragma once

#include <string>

#include "core/mesh/plane_frame.h"
#include "core/motion/handle.h"

namespace wend {

/// The word for the rest surface in a project's `hold`.
inline const std::string kRestSurface = "rest";

/// Reads a surface to slide on from a mesh file: its triangles, or the boundary of its volume, or its lines
/// where it has no triangles. For the `plane` of a flat shape: its lines, or the border of its triangles, in
/// the coordinates of that plane. Throws InputError(path, place and reason).
GuideMesh<3> readGuide(const std::string& path, const PlaneFrame* plane = nullptr);

}  // namespace wend
