#pragma once

#include <ranges>
#include <string>
#include <vector>

#include "app/project/extras.h"
#include "app/project/id.h"
#include "core/mesh/region.h"

namespace wend {

/// A region of the rest shape with a soft edge.
struct SoftRegion {
    Region<3> shape;
    double feather = 0;     // the width of the soft edge
    std::string part = {};  // of a picture, the only one that it is for; empty: all
    Extras extras = {};
    bool operator==(const SoftRegion&) const = default;
};

/// Regions with one value, which were painted together: the factor of the lengths of edges there, or their
/// order in depth. In a file they are consecutive regions of one name and value; regions without a name are
/// layers of their own. Later layers win over earlier ones.
struct ValueLayer {
    std::string name;  // may be empty
    double value = 1;
    std::vector<SoftRegion> regions;
    Id id = newId();

    /// Compares all but the ids.
    bool operator==(const ValueLayer& other) const {
        return name == other.name && value == other.value && regions == other.regions;
    }
};

/// Returns a view of the regions of all layers, in the order of the file.
template <class Layers>
auto regionsOf(Layers& layers) {
    return layers | std::views::transform([](auto& layer) -> auto& { return layer.regions; }) |
           std::views::join;
}

}  // namespace wend
