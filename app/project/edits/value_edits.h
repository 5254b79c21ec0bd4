#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/project/layer.h"
#include "app/project/project_fwd.h"

namespace wend {

// Edits of the sizes of cells and of the depth of a project.

/// Adds a stroke of balls with a factor of the lengths of edges on top of all layers, named "Stroke 1",
/// "Stroke 2" …, and removes regions that it covers completely. Where nothing is left, a stroke of the value
/// that there is elsewhere adds nothing.
ValueLayers withSizeStroke(ValueLayers sizes, std::vector<SoftRegion> stroke, double factor);
/// Adds a region on top of all layers, named "Region 1", "Region 2" …
ValueLayers withSizeRegion(ValueLayers sizes, const Region<3>& shape, double factor);
/// Adds a stroke with an order, named "Depth 1", "Depth 2" …, as withSizeStroke() does.
ValueLayers withDepthStroke(ValueLayers depth, std::vector<SoftRegion> stroke, double order);

/// Sets the order of the surroundings of handles, in layers of their names that replace earlier ones; 0
/// removes them. `size` is that of the rest shape; a handle of points reaches halfway to the nearest other
/// one, up to a fraction of that size.
ValueLayers withHandleDepth(ValueLayers depth, const Design& design, const std::vector<int>& handles,
                            double order, double size);
/// Returns the order that withHandleDepth() gave to the handle of that name, if it did.
std::optional<double> depthOfHandle(const ValueLayers& depth, const std::string& name);

}  // namespace wend
