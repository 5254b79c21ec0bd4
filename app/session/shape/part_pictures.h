#pragma once

#include <map>
#include <string>
#include <vector>

#include "app/document/part.h"
#include "warp/atlas.h"

namespace wend {

/// The pictures of a project's parts.
struct PartPictures {
    std::vector<PicturePart> parts;  // that they are of
    std::vector<Sheet> sheets;       // of each
    int width = 0, height = 0;       // of the files with layers, or of all sheets together
};

/// Reads the pictures of parts, as far as `known` does not have them. Notices are those of reading, and tell
/// of blend modes that layers are not shown with. Throws InputError that names the file.
PartPictures loadParts(const std::vector<PicturePart>& parts, const std::string& folder,
                       const PartPictures& known, std::vector<std::string>* notices);

}  // namespace wend
