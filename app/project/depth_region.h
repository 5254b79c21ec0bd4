#pragma once

#include <string>

#include "app/project/extras.h"
#include "core/mesh/region.h"

namespace wend {

/// A part of a picture's rest shape that is in front of the rest (order > 0) or behind it (< 0) where the
/// shape overlaps itself.
struct DepthRegion {
    std::string name;  // regions of one name belong together; may be empty
    Region<3> shape;
    double order = 0;
    std::string part = {};  // of a picture, that alone is changed; empty: whatever lies there
    Extras extras = {};
    bool operator==(const DepthRegion&) const = default;
};

}  // namespace wend
