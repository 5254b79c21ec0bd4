#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/mesh/cell_kind.h"

namespace wend::formats {

/// An element type of Gmsh. `order[k]` is where VTK's node k stands in Gmsh's list; empty: they agree.
struct GmshElement {
    int number;
    CellKind kind;
    std::vector<int> order;
};

/// Null for types that are not read.
const GmshElement* gmshElement(int number);
/// Null for kinds that Gmsh has not.
const GmshElement* gmshElement(CellKind kind);
/// What an unread type is called, as "a tetrahedron of third order".
std::string unreadGmshElement(int number);

}  // namespace wend::formats
