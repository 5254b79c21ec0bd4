#pragma once

#include <vector>

#include "core/meshing/surface.h"

namespace wend {

/// What counts of a surface: without triangles that are degenerate, double or of missing vertices, and with
/// one vertex at every place.
struct SoundPart {
    Surface surface;
    std::vector<int> triangles;  // whose they are in the whole surface

    explicit SoundPart(const Surface& whole);
    /// The triangles that are connected with one through edges and agree with it, in the whole surface's
    /// numbers.
    std::vector<int> patchOf(int triangle) const;
};

}  // namespace wend
