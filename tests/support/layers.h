#pragma once

#include <string>
#include <utility>
#include <vector>

#include "app/project/design.h"

namespace wend::test {

/// Returns copies of all regions of a design, in the order of the file.
inline std::vector<MaterialRegion> regionsIn(const Design& design) {
    std::vector<MaterialRegion> all;
    for (const MaterialRegion& region : regionsOf(design.material.layers)) all.push_back(region);
    return all;
}

/// Returns a layer of one region.
inline MaterialLayer layerWith(std::string name, MaterialRegion region) {
    return {std::move(name), {std::move(region)}};
}
inline ValueLayer layerWith(std::string name, double value, Region<3> shape, double feather = 0) {
    return {std::move(name), value, {{std::move(shape), feather}}};
}

}  // namespace wend::test
