#pragma once

#include "core/base/message.h"
#include "warp/image.h"
#include "warp/vector_drawing.h"

namespace wend {

/// These are readImage(), readLayer() and readImageHeader() for drawings in a size that is given; a picture
/// of pixels has its own. The height follows the drawing's proportions if the size has others.
Image readImage(const std::string& path, const DrawnSize& drawn, std::vector<Message>* notices = nullptr);
Image readLayer(const std::string& path, const std::string& layer, const DrawnSize& drawn,
                std::vector<Message>* notices = nullptr);
Image readImageHeader(const std::string& path, const DrawnSize& drawn);

/// Returns whether a file that can be read is an SVG drawing.
bool isDrawing(const std::string& path);

}  // namespace wend
