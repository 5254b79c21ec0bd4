#pragma once

#include "app/session/shape/shape.h"
#include "warp/open_raster.h"

namespace wend {

struct View;
struct WarpOptions;

/// Returns whether the name is that of an OpenRaster file, which gets every part as a layer.
bool isLayeredFile(const std::string& path);

/// The parts of a pose as layers, from front to back as their `levels` say (partLevels()), each as large as
/// what is seen of it in the view. `pixels`: inPixels(). A shape without parts is one layer. Throws
/// Cancelled.
std::vector<LayerToWrite> warpedLayers(const Shape<2>& shape, const Points<2>& pixels,
                                       const std::vector<int>& levels, const View& view,
                                       const WarpOptions& options);

}  // namespace wend
