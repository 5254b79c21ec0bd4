#pragma once

#include <string>
#include <vector>

#include "warp/picture_format.h"
#include "warp/picture_metadata.h"

namespace wend {

/// The content of a file with layers.
struct LayeredFile {
    std::string merged;  // a file of the picture of all layers: a PNG, or a Photoshop file
    std::vector<PictureLayer> layers;
    std::vector<Message> notices = {};
};

/// Reads a ZIP archive with `mergedimage.png` and a description of the layers (stack.xml or maindoc.xml).
/// Throws InputError(path, reason).
LayeredFile readLayeredFile(const std::string& path, PictureFormat format);

/// Makes the names of layers different: of equal ones, later ones get a number, "hand (2)", or behind another
/// mark, "hand_2"; no name: "layer".
void giveOwnNames(const std::vector<std::string*>& names, const std::string& mark = {});

/// Returns the place of the layer with that name. Throws InputError without a file if there is none.
std::size_t layerNamed(const std::vector<PictureLayer>& layers, const std::string& name);

/// Reads the picture of one layer, a PNG file, of an OpenRaster or Krita file. Throws
/// InputError(path, reason).
std::string readLayerPicture(const std::string& path, PictureFormat format, const std::string& name);

/// Returns whether a group of that mode shows its layers as they are.
bool isPlainBlend(const std::string& mode);

}  // namespace wend
