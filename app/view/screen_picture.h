#pragma once

#include <QImage>
#include <memory>

#include "warp/image.h"

namespace wend {

/// A picture in the 8 bits of the screen: itself if it has them, otherwise converted; light of half and float
/// files is encoded as in sRGB. Alpha stays associated or not, so that a warp of it is a warp of the
/// original.
std::shared_ptr<const Image> screenPicture(const std::shared_ptr<const Image>& picture);

/// The pixels of a warp of such a picture.
QImage toQImage(const Image& warped);

}  // namespace wend
