#pragma once

#include <string>
#include <vector>

#include "app/document/part.h"
#include "warp/image.h"

namespace wend {

/// Returns the layers of an OpenRaster or Photoshop file as parts, from front to back; none if there are
/// fewer than two that show anything, or if they cannot be read. Hidden layers
/// are hidden parts. A layer that is too small for an outline of its own rides on the next one below it.
/// `picture`: of all layers. `notices` receives why a file with layers has no parts.
std::vector<PicturePart> partsOfLayers(const std::string& path, const Image& picture,
                                       std::vector<std::string>& notices);

}  // namespace wend
