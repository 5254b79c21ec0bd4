#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/project/depth_region.h"
#include "app/project/project_fwd.h"

namespace wend {

/// Adds a stroke with an order above all regions, named "Depth 1", "Depth 2" …, and removes strokes that it
/// covers completely.
DepthRegions withDepthStroke(const DepthRegions& depth, const std::vector<Ball<3>>& balls, double order,
                             const std::string& part = {});

/// Sets the order of the surroundings of handles, in regions of their names that replace earlier ones; 0
/// removes them. `size` is that of the rest shape; a handle of points reaches halfway to the nearest other
/// one, up to a fraction of that size.
DepthRegions withHandleDepth(const DepthRegions& depth, const Design& design, const std::vector<int>& handles,
                             double order, double size);
/// The order that the handle of a name has given; nothing if none.
std::optional<double> depthOfHandle(const DepthRegions& depth, const std::string& name);

}  // namespace wend
