#pragma once

#include <span>
#include <string>

#include "app/project/design.h"
#include "core/mesh/simplicial_mesh.h"

namespace wend {

/// The place and strength of an eraser.
struct Eraser {
    Region<3> shape;
    double feather = 0;
    double amount = 1;
    int cell = 0;           // that the amount is of; of no account where all is erased
    std::string part = {};  // of a picture, that alone is erased; empty: whatever lies there
};

/// Removes paint from all visible layers, so that the shape behaves as elsewhere, even after later changes.
/// Adds no layer.
template <int Dim>
Design withErased(const Design& design, std::span<const Eraser> erasers, const SimplicialMesh<Dim>& rest,
                  const std::string& folder);

/// Removes visible layers of which erasing has left almost nothing.
template <int Dim>
Design withoutErasedLayers(const Design& design, const SimplicialMesh<Dim>& rest, const std::string& folder);

}  // namespace wend
