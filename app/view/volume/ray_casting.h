#pragma once

#include "app/tools/solid_surface.h"
#include "core/mesh/cut_plane.h"
#include "core/mesh/triangle_tree.h"

namespace wend {

/// What a ray has met of the surface; cell −1 if it is nothing.
SolidHit solidHit(const CutSurface& surface, const Points<3>& pose, const Ray& ray,
                  const TriangleTree::Hit& hit);

}  // namespace wend
