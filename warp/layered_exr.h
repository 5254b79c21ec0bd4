#pragma once

#include <optional>

#include "warp/open_raster.h"

namespace wend {

/// Writes an EXR file of a picture (R, G, B, A) and of its layers on the same canvas (NAME.R …), each with
/// its opacity, also those that are hidden. Values are associated, halves of 8 bits and floats of more, or of
/// the type that is given. `path` is written whole or not at all. Throws InputError.
void writeLayeredExr(const std::string& path, const Image& merged, const std::vector<LayerToWrite>& layers,
                     std::optional<PixelType> type = std::nullopt);

/// The most bytes of a layer's name in channels, of whose names OpenEXR holds 255.
constexpr std::size_t kLongestChannelName = 200;

/// Returns the names of layers as they are in channels: without dots and spaces, not too long, all different.
std::vector<std::string> channelNames(const std::vector<LayerToWrite>& layers);

}  // namespace wend
