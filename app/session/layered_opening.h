#pragma once

#include <string>
#include <vector>

#include "app/project/part.h"
#include "core/base/message.h"
#include "warp/image.h"
#include "warp/vector_drawing.h"

namespace wend {

/// Returns the layers of an OpenRaster or Photoshop file as parts, from front to back; none if fewer than two
/// layers have visible content, or if they cannot be read. Hidden layers become hidden parts. A layer that is
/// too small for an outline of its own is attached to the next one below it. `picture` is that of all layers.
/// `notices` receives the reason if a file with layers has no parts. A drawing is drawn in the size `drawn`.
std::vector<PicturePart> partsOfLayers(const std::string& path, const Image& picture, const DrawnSize& drawn,
                                       std::vector<Message>& notices);

}  // namespace wend
