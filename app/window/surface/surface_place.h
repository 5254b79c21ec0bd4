#pragma once

#include "core/meshing/surface.h"

namespace wend {

/// The default direction of view on a surface.
inline const Vec<3> kAskew(-1, 1.4, -0.8);

/// Returns points around some triangles, a little farther away than their corners.
Points<3> surroundingsOf(const Surface& surface, const std::vector<int>& triangles);

/// Returns false for triangles between the viewer and these points.
std::vector<bool> notBefore(const Surface& surface, const Points<3>& place, const Vec<3>& direction);

/// Returns the direction against the triangle's outer side, slightly from above.
Vec<3> intoTriangle(const Surface& surface, int triangle);

}  // namespace wend
