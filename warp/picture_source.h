#pragma once

#include <string>
#include <vector>

#include "core/base/message.h"
#include "warp/picture_library.h"
#include "warp/vector_drawing.h"

namespace wend {

/// Returns what a picture's file is by its content, not by its name, with the facts that its format's library
/// does not report; a drawing is drawn in that size. `notices` receives what the user should know. Throws
/// InputError.
PictureSource sourceOf(const std::string& path, const DrawnSize& size, std::vector<Message>& notices);

/// Does the same for one layer of a file with layers.
PictureSource layerSourceOf(const std::string& path, const std::string& layer, const DrawnSize& size,
                            std::vector<Message>& notices);

/// Returns the paths of an SVG drawing, or of one of its layers.
VectorDrawing vectorSourceOf(const std::string& path, const std::string& layer, const DrawnSize& size);

}  // namespace wend
