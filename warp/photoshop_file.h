#pragma once

#include <optional>

#include "warp/open_raster.h"

namespace wend {

/// Writes a Photoshop file (PSD): the layers, the first one on top, each with its name, place, opacity,
/// visibility and blend mode, and the picture of all of them. Types are those of `merged`, or the type that
/// is given: 8 bits, or 16 for all others. `path` is written whole or not at all. Throws InputError, also
/// where the format's limits of 30,000 pixels a side and 2 GB are exceeded. The format: Adobe, "Photoshop
/// File Formats Specification", 2019.
void writePhotoshopFile(const std::string& path, const std::vector<LayerToWrite>& layers, const Image& merged,
                        std::optional<PixelType> type = std::nullopt);

}  // namespace wend
