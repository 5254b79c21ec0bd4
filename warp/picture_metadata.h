#pragma once

#include <string>
#include <vector>

#include "warp/image.h"

namespace wend {

/// A group of layers.
struct LayerGroup {
    int id = 0;  // other groups of the file have others
    std::string name = {};
    std::string blend = {};
    double opacity = 1;
    bool visible = true, clipped = false, atop = false;  // as of layers
    bool isolated = true;  // its layers are combined with one another before they lie over what is below it
    bool operator==(const LayerGroup&) const = default;
};

/// A layer of a file whose picture was read with all layers merged.
struct PictureLayer {
    std::string name;
    int x = 0, y = 0;           // of its first pixel
    int width = 0, height = 0;  // 0: not known
    double opacity = 1;
    std::string blend;  // mode; empty if the file's library knows neither it nor opacity and visibility
    bool visible = true;
    bool clipped = false;                   // it shows only where the one below is
    std::string unread = {};                // why its pixels cannot be read: "is a vector layer"
    std::vector<std::string> leftOut = {};  // what is not shown of it: "its filter mask"
    double ownOpacity = 1;                  // without that of its groups
    std::vector<LayerGroup> groups = {};    // that it is in, the outermost first
    bool atop = false;                      // it leaves the alpha of all that is below it in its group
};

/// The metadata of every picture that was read from a file.
struct PictureMetadata final : Image::Metadata {
    std::string description;           // what the format's library knows of the file, packed by it
    std::vector<PictureLayer> layers;  // that are merged in the picture, in the file's order
};

/// Returns what a picture's file has; null for a picture that was not read from one.
inline const PictureMetadata* fileMetadata(const Image& image) {
    return static_cast<const PictureMetadata*>(image.metadata.get());  // nothing else makes any
}

}  // namespace wend
