#pragma once

#include <QImage>

#include "warp/image.h"

namespace wend {

/// A picture as the screen needs it: RGBA, 8 bits, colours associated with alpha; light of half and float
/// files encoded as in sRGB.
Image toScreen(const Image& picture);

/// The pixels of such a picture.
QImage toQImage(const Image& screen);

}  // namespace wend
