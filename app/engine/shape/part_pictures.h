#pragma once

#include <memory>
#include <stop_token>
#include <string>
#include <vector>

#include "app/engine/shape/part_cut.h"
#include "core/base/message.h"
#include "warp/vector_drawing.h"

namespace wend {

/// A picture or layer that parts are made of.
struct PartSource {
    std::string path, layer;
    std::shared_ptr<const Image> picture;
};

/// A cut that has been made, and what it was made of.
struct PartCut {
    std::shared_ptr<const Image> whole;
    Vec<2> at;
    Outline cut;
    double feather = 0;
    bool fill = false;
    CutPictures pictures;
};

/// The pictures of a project's parts.
struct PartPictures {
    std::vector<PicturePart> parts;
    std::vector<Sheet> sheets;  // of each
    int width = 0, height = 0;  // of the files with layers, or of all sheets together
    DrawnSize drawn{};          // of drawings
    std::vector<PartSource> sources;
    std::vector<PartCut> cuts;
};

/// Reads the pictures of parts and makes the cuts, except those that `known` has. Notices are those of
/// reading, and name blend modes that are not shown. Drawings are drawn in the size `drawn`. Throws
/// InputError that names the file, and Cancelled.
PartPictures loadParts(const std::vector<PicturePart>& parts, const std::string& folder,
                       const PartPictures& known, std::vector<Message>* notices, const DrawnSize& drawn,
                       const std::stop_token& stop = {});

/// Returns the parts without what takes time and is visible in motion only: the filled grounds behind cuts.
std::vector<PicturePart> atRest(std::vector<PicturePart> parts);

}  // namespace wend
