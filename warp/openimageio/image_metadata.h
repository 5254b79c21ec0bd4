#pragma once

#include <OpenImageIO/imageio.h>

#include "warp/image.h"

namespace wend {

/// OpenImageIO's description of a picture apart from its pixels.
struct OpenImageIOMetadata final : Image::Metadata {
    OIIO::ImageSpec spec;

    /// The picture's size, and its first pixel in the coordinates of its file.
    int frameWidth() const { return hasWindow() ? spec.full_width : spec.width; }
    int frameHeight() const { return hasWindow() ? spec.full_height : spec.height; }
    int left() const { return hasWindow() ? spec.full_x : spec.x; }
    int top() const { return hasWindow() ? spec.full_y : spec.y; }

  private:
    bool hasWindow() const { return stored.width > 0; }
};

}  // namespace wend
