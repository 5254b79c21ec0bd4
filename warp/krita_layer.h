#pragma once

#include <pugixml.hpp>
#include <string>
#include <vector>

#include "core/base/zip_archive.h"
#include "warp/picture_metadata.h"

namespace wend {

/// Where a Krita file has the pixels of a layer.
struct KritaLayer {
    struct Mask {
        std::string file;
        int x = 0, y = 0;  // of its pixel (0, 0) in the picture
    };
    std::string file;     // in the archive
    std::string colours;  // name of their kind
    int x = 0, y = 0;     // of the file's pixel (0, 0) in the picture
    PixelBox box;         // that is read, in the picture
    std::vector<Mask> masks;
};

/// Describes a layer of maindoc.xml: sets the place and size of `layer`, and why it cannot be read or what is
/// left out of it. Throws InputError(path, reason).
KritaLayer kritaLayerOf(const ZipArchive& zip, const pugi::xml_node& node, PictureLayer& layer);

/// Returns a PNG file of a layer that can be read, with its transparency masks applied. Throws
/// InputError(path, reason).
std::string kritaLayerPicture(const ZipArchive& zip, const KritaLayer& layer);

}  // namespace wend
