#pragma once

#include "core/meshing/surface_fixes.h"

namespace wend {

/// Fixes all cases of a kind repeatedly, each as fixFor() does, as long as that helps. Holes of more than
/// `largestHole` edges remain.
FaultFix fixForAll(const Surface& surface, const std::vector<SurfaceFix>& done, const std::string& kind,
                   int largestHole);

}  // namespace wend
