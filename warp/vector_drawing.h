#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/base/message.h"

namespace wend {

/// The size in pixels at which a drawing becomes a picture; zeros: its own, or larger if that is small.
using DrawnSize = std::array<int, 2>;

/// A picture in a drawing: pixels of red, green, blue and alpha, 8 bits each and not associated.
struct DrawnPicture {
    int x = 0, y = 0, width = 0, height = 0;  // in the pixels of the drawing
    std::string pixels;
};

/// An SVG drawing in which all that is drawn is a path or a picture. `svg` holds these elements: <g>;
/// <path> with absolute pieces in the coordinates of the view box, whatever its `transform`, within which its
/// pen, its paints and its markers are; <image> with the number of one of the `pictures` in `data-picture`;
/// and in <defs> what they refer to: a gradient or pattern belongs to one path each, its transform leads to
/// the coordinates of the view box; clip paths and masks hold paths; filters and markers are the file's own.
struct VectorDrawing {
    std::string svg;
    std::array<double, 4> viewBox{0, 0, 1, 1};  // which is drawn as so many pixels:
    int width = 1, height = 1;
    std::string ownWidth, ownHeight;  // as the file says them
    std::vector<DrawnPicture> pictures;
    std::vector<Message> notices;  // of what is left out or cannot be as it was
};

}  // namespace wend
