#pragma once

#include <string>
#include <vector>

#include "warp/picture_metadata.h"
#include "warp/vector_drawing.h"

namespace wend {

/// A drawing as pixels.
struct DrawnSvg {
    std::vector<PictureLayer> layers;  // its groups, from front to back
    std::string picture;               // a PNG file of all of them, or of the one that was asked for
};

/// Draws SVG files, by Qt's own library. wend-picture loads it with the first drawing (svgLibrary()). The
/// functions throw InputError without a file.
class SvgLibrary {
  public:
    virtual ~SvgLibrary() = default;
    /// Draws all of a drawing, or one layer as large as what is seen of it.
    virtual DrawnSvg draw(const std::string& svg, const std::string& layer, const DrawnSize& size) const = 0;
    /// Returns all of it, or one layer, as paths.
    virtual VectorDrawing vectors(const std::string& svg, const std::string& layer,
                                  const DrawnSize& size) const = 0;
};

/// Returns the module beside the program. Throws InputError without a file.
const SvgLibrary& svgLibrary();

}  // namespace wend
