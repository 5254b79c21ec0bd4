#pragma once

#include "core/meshing/surface_fixes.h"

namespace wend {

/// Fixes all cases of a kind repeatedly as long as that helps, in the way of fixFor. Holes of more than
/// `largestHole` edges stay.
FaultFix fixForAll(const Surface& surface, const std::vector<SurfaceFix>& done, const std::string& kind,
                   int largestHole);

}  // namespace wend
