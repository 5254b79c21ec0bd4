#pragma once

#include <string>
#include <vector>

#include "warp/blend_mode.h"
#include "warp/image.h"

namespace wend {

/// A layer that is written to a file, with its first pixel at (x, y) of the picture.
struct LayerToWrite {
    std::string name;
    Image picture;
    int x = 0, y = 0;
    double opacity = 1;
    bool visible = true;
    BlendMode blend = BlendMode::Normal;
};

/// Writes an OpenRaster file: the layers, the first one on top, as PNG files in a ZIP archive, their
/// description, the picture of all of them, and a small one. `path` is a temporary name. Throws InputError.
/// The format: https://www.openraster.org/baseline/file-layout-spec.html
void writeOpenRaster(const std::string& path, const std::vector<LayerToWrite>& layers, const Image& merged);

}  // namespace wend
