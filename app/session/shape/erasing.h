#pragma once

#include <span>
#include <string>

#include "app/document/design.h"
#include "core/mesh/simplicial_mesh.h"

namespace wend {

/// Where something is erased, and how much of what was there at a cell.
template <int Dim>
struct Eraser {
    Region<Dim> shape;
    double feather = 0;
    double amount = 1;
    int cell = 0;  // that the amount is of; of no account where all is erased
};

/// What was painted there is taken off all layers that are seen: the shape is there as everywhere, whatever
/// that will be. No layer is added.
template <int Dim>
Design<Dim> withErased(const Design<Dim>& design, std::span<const Eraser<Dim>> erasers,
                       const SimplicialMesh<Dim>& rest, const std::string& folder);

/// Without the layers that are seen and of which erasing has left next to nothing.
template <int Dim>
Design<Dim> withoutErasedLayers(const Design<Dim>& design, const SimplicialMesh<Dim>& rest,
                                const std::string& folder);

}  // namespace wend
