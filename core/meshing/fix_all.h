#pragma once

#include "core/meshing/surface_fixes.h"

namespace wend {

/// For all cases of a kind together, again and again as long as that helps: what fixFor would do about each.
/// Holes of more edges than `largestHole` stay.
FaultFix fixForAll(const Surface& surface, const std::vector<SurfaceFix>& done, const std::string& kind,
                   int largestHole);

}  // namespace wend
