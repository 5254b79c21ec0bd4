#pragma once

#include "app/session/shape/shape.h"
#include "warp/open_raster.h"

namespace wend {

struct View;
struct WarpOptions;

/// Returns whether the name is that of an OpenRaster file, which gets every part as a layer.
bool isLayeredFile(const std::string& path);

/// Returns the parts of a pose as layers, from front to back in the order of their `levels` (partLevels()),
/// each as large as its visible area in the view. `pixels` is inPixels(). A shape without parts is one layer.
/// Throws Cancelled.
std::vector<LayerToWrite> warpedLayers(const Shape<2>& shape, const Points<2>& pixels,
                                       const std::vector<int>& levels, const View& view,
                                       const WarpOptions& options);

}  // namespace wend
