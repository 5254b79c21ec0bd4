#pragma once

#include <vector>

#include "core/meshing/surface.h"

namespace wend {

/// The valid part of a surface: without degenerate, duplicate or dangling triangles, and with merged
/// vertices.
struct SoundPart {
    Surface surface;
    std::vector<int> triangles;  // their numbers in the whole surface

    explicit SoundPart(const Surface& whole);
    /// Returns the triangles that are connected with one through edges and agree with it, in the whole
    /// surface's numbers.
    std::vector<int> patchOf(int triangle) const;
};

}  // namespace wend
