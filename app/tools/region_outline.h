#pragma once

#include <vector>

#include "app/session/pins.h"
#include "app/tools/shape_view.h"
#include "core/mesh/region.h"

namespace wend {

/// Returns lines that show a region: three circles of a ball, the edges of a box, a square and an arrow into
/// a half-space, the segment of a blend. `low` and `high`: the box in which a plane is shown.
std::vector<std::vector<Vec3>> regionOutline(const Region<3>& region, const Vec3& low, const Vec3& high);

/// Draws regions of a solid where they are now; of many balls one circle each.
void paintRegions(QPainter& painter, ShapeView& view, const std::vector<Region<3>>& regions, const QPen& pen);

/// Returns the border, where it now is, of a part of a picture that is held as a whole; if the region is
/// unbounded, the hull of its points.
std::vector<Vec3> regionBorder(const Pin& handle, const PinView& view, const ShapeFrame& frame);

}  // namespace wend
