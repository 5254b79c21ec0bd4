#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/base/message.h"
#include "warp/image.h"
#include "warp/picture_format.h"
#include "warp/picture_metadata.h"

namespace wend {

/// A layer as it can be shown by itself. Several are one if they are combined with one another before they
/// lie over anything else: layers and what clips them, and those of a group with an opacity or a blend mode
/// of its own, or of an isolated group in which all but one are blended with that one.
struct ShownLayer {
    PictureLayer layer;  // with the name of the merged picture: "arm + shade"; of a group its own
    std::string name;    // of what it shows: that of the layer at the back, or of the group
    std::vector<std::string> merges = {};  // the names of the layers from back to front; empty: it is one
};

/// Returns the layers of a file in the order from front to back.
std::vector<PictureLayer> fromTheFront(std::vector<PictureLayer> layers, PictureFormat format);

/// Returns what is shown of layers from front to back, without those that cannot be read.
std::vector<ShownLayer> shownLayers(const std::vector<PictureLayer>& layers);

/// A picture of several layers, and the place of its first pixel.
struct MergedPicture {
    Image picture;
    int x = 0, y = 0;
};

/// Composites the layers of a shown layer that merges some, in the numbers of the file. `read` returns the
/// picture of one layer. Notices name blend modes that are not shown.
MergedPicture mergedPicture(const std::vector<PictureLayer>& layers, const ShownLayer& shown,
                            const std::function<Image(const std::string& layer)>& read,
                            std::vector<Message>* notices);

}  // namespace wend
