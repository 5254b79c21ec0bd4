#pragma once

#include <memory>
#include <stop_token>
#include <string>
#include <vector>

#include "app/project/part.h"
#include "core/base/message.h"
#include "warp/atlas.h"
#include "warp/vector_drawing.h"

namespace wend {

/// A part that is cut out of another one's picture.
struct CutPictures {
    Sheet taken;                        // the part, in a picture that is hardly larger than the cut
    std::shared_ptr<const Image> left;  // what remains of the other one
};

/// Cuts a part out of a picture. At rest, both over one another give the picture again. Without
/// PicturePart::fill, pixels that the part does not hide at rest remain below it, and the others become
/// transparent. With it, the area that the part hides is inpainted, and the ground's colours are removed from
/// the part's soft edge (see separated()); `notices` says if that is not possible. Throws InputError and
/// Cancelled.
CutPictures cutOut(const PicturePart& part, const Sheet& from, std::vector<Message>* notices,
                   const std::stop_token& stop);

/// A picture or layer that parts are made of.
struct PartSource {
    std::string path, layer;
    std::shared_ptr<const Image> picture;
};

/// A cut that has been made, and what it was made of.
struct PartCut {
    std::shared_ptr<const Image> whole;
    Vec2 at;
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
