#pragma once

#include <vector>

#include "core/mesh/region.h"

namespace wend {

/// Lines that show a region: three circles of a ball, the edges of a box, a square and an arrow into a
/// half-space, the segment of a blend. `low` and `high`: what a plane is to be seen beside.
std::vector<std::vector<Vec<3>>> regionOutline(const Region<3>& region, const Vec<3>& low,
                                               const Vec<3>& high);

}  // namespace wend
