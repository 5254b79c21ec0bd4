#pragma once

#include "app/view/volume/volume_view.h"

namespace wend {

/// The nearest triangle that the ray meets, from either side (Möller and Trumbore 1997).
SolidHit nearestHit(const CutSurface& surface, const Points<3>& pose, const Ray& ray);

/// Drops the vertices that a triangle hides.
void keepVisible(std::vector<int>& vertices, const CutSurface& surface, const Points<3>& pose,
                 const Camera& camera, const QSize& viewport);

}  // namespace wend
