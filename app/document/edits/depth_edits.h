#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/document/depth_region.h"
#include "app/document/project_fwd.h"

namespace wend {

/// A stroke that brings what it covers to an order, above all regions, named "Depth 1", "Depth 2" … Strokes
/// that it hides wholly go.
DepthRegions withDepthStroke(const DepthRegions& depth, const std::vector<Ball<2>>& balls, double order);

/// Handles bring what lies around them to an order, in regions of their names that replace those they had; 0
/// takes these away. `size`: the rest shape's; a handle of points reaches half the way to the nearest other
/// one, but no farther than a part of that.
DepthRegions withHandleDepth(const DepthRegions& depth, const Design<2>& design,
                             const std::vector<int>& handles, double order, double size);
/// The order that the handle of a name has given; nothing if none.
std::optional<double> depthOfHandle(const DepthRegions& depth, const std::string& name);

}  // namespace wend
