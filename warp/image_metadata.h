#pragma once

#include <OpenImageIO/imageio.h>

#include "warp/image.h"

namespace wend {

/// What the file said about the picture besides its pixels. Private to the readers and writers: it drags in
/// OpenImageIO.
struct Image::Metadata {
    OIIO::ImageSpec spec;
};

}  // namespace wend
