#pragma once

#include <vector>

#include "core/mesh/simplicial_mesh.h"
#include "core/mesh/skin.h"

namespace wend {

/// The skin's point next to each vertex of the solid's border at rest; −1 for vertices inside.
std::vector<int> nearestSkinPoints(const Skin& skin, const Points<3>& rest,
                                   const std::vector<Facet<3>>& border);

}  // namespace wend
