#pragma once

#include <string>
#include <vector>

#include "warp/picture_metadata.h"

namespace wend {

/// A drawing as pixels.
struct DrawnSvg {
    std::vector<PictureLayer> layers;  // its groups, from front to back
    std::string picture;               // a PNG file of all of them, or of the one that was asked for
};

/// Draws SVG files, by Qt's own library. wend-picture loads it with the first drawing (drawnSvg()).
class SvgLibrary {
  public:
    virtual ~SvgLibrary() = default;
    /// Draws all of a drawing, or one layer as large as what is seen of it. Throws InputError without a file.
    virtual DrawnSvg draw(const std::string& svg, const std::string& layer) const = 0;
};

/// The same by the module beside the program. Throws InputError(path, reason).
DrawnSvg drawnSvg(const std::string& path, const std::string& svg, const std::string& layer);

}  // namespace wend
