#pragma once

#include <OpenImageIO/imageio.h>

#include "warp/image.h"

namespace wend {

/// All that OpenImageIO says about a picture besides its pixels.
struct OpenImageIOMetadata final : Image::Metadata {
    OIIO::ImageSpec spec;
};

}  // namespace wend
