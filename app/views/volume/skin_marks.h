#pragma once

#include <vector>

#include "core/mesh/simplicial_mesh.h"
#include "core/mesh/skin.h"

namespace wend {

/// Returns the nearest skin point of each vertex on the solid's border at rest; −1 for inner vertices.
std::vector<int> nearestSkinPoints(const Skin& skin, const Points<3>& rest,
                                   const std::vector<Facet<3>>& border);

}  // namespace wend
