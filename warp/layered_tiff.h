#pragma once

#include <optional>

#include "core/base/message.h"
#include "warp/open_raster.h"

namespace wend {

/// Writes a TIFF file whose pages are the layers, as GIMP and Krita read them: the backmost one first and as
/// large as the picture, each with its name and place. Types are those of `merged`, the picture of all
/// layers, or the type that is given. `path` is written whole or not at all. Throws InputError.
void writeLayeredTiff(const std::string& path, const Image& merged, const std::vector<LayerToWrite>& layers,
                      std::optional<PixelType> type = std::nullopt);

/// Returns what such a file does not hold of the layers; empty if nothing is lost.
Message lostInLayeredTiff(const std::vector<LayerToWrite>& layers);

}  // namespace wend
