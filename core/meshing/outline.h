#pragma once

#include <vector>

#include "core/base/types.h"

namespace wend {

/// A part of the plane: closed polygons; a point is inside if an odd number of them encloses it (holes,
/// islands in holes).
struct Outline {
    std::vector<std::vector<Vec2>> loops;
    bool operator==(const Outline&) const = default;
};

}  // namespace wend
