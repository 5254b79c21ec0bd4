#pragma once

#include <optional>

#include "app/engine/shape/shape.h"
#include "warp/open_raster.h"

namespace wend {

struct View;
struct WarpOptions;

/// Returns whether the name is that of a file which gets every part as a layer: OpenRaster or Photoshop.
bool isLayeredFile(const std::string& path);

/// Writes a file that isLayeredFile(), or an EXR file with the parts as channels, whole or not at all. Throws
/// InputError.
void writeLayers(const std::string& path, const std::vector<LayerToWrite>& layers, const Image& merged,
                 std::optional<PixelType> depth);

/// Returns the pixels of the view in which cells are visible, with one more on every side; empty if there are
/// none.
PixelBox visibleBox(const View& view, const Points2& pixels, const std::vector<Cell<2>>& cells);

/// Return the cells of a part, and its values of all that the cells have.
std::vector<Cell<2>> partCells(const SimplicialMesh<2>& mesh, const MeshPart& part);
std::vector<float> partDepths(const std::vector<float>& all, const MeshPart& part);

/// Returns one part of a pose, with the order of its own cells, as large as its visible area in the view.
LayerToWrite warpedPart(const Texture& texture, std::size_t k, const Points2& pixels, const View& view,
                        WarpOptions options);

/// Returns whether a picture of that name gets the parts of the shape, too, as the channels of an EXR file.
bool getsPartChannels(const std::string& path, const Shape<2>& shape);

/// Returns the ST maps of the parts, each as if it were alone. The picture has that size at rest, and `depth`
/// is that of WarpOptions.
std::vector<LayerToWrite> stMapsOfParts(const Shape<2>& shape, const Points2& pixels, const View& view,
                                        const std::vector<float>& depth);

/// Returns the parts of a pose as layers, from front to back in the order of their `levels` (partLevels()),
/// each as large as its visible area in the view. `pixels` is inPixels(). A shape without parts is one layer.
/// Throws Cancelled.
std::vector<LayerToWrite> warpedLayers(const Shape<2>& shape, const Points2& pixels,
                                       const std::vector<int>& levels, const View& view,
                                       const WarpOptions& options);

}  // namespace wend
