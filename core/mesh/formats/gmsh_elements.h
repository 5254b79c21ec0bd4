#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/mesh/cell_kind.h"

namespace wend::formats {

/// An element type of Gmsh. `order[k]` is the position of VTK's node k in Gmsh's list; it is empty if both
/// orders agree.
struct GmshElement {
    int number;
    CellKind kind;
    std::vector<int> order;
};

/// Returns the element type with a number; null for types that are not read.
const GmshElement* gmshElement(int number);
/// Returns the element type of a kind; null for kinds that Gmsh does not have.
const GmshElement* gmshElement(CellKind kind);
/// Describes an element type that is not read, as "a tetrahedron of third order".
std::string unreadGmshElement(int number);

}  // namespace wend::formats
