#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "core/mesh/cell_kind.h"

namespace wend {
struct MeshFile;
}

namespace wend::formats {

/// A type of element in Exodus files: the beginning of its name, and for each node in VTK's order its place
/// there.
struct ExodusType {
    std::string_view name;
    CellKind kind;
    std::vector<int> order;  // empty: the same
};
/// Returns the type of a kind of cell; null if the format has none.
const ExodusType* exodusTypeOf(CellKind kind);
/// Returns the type with a name and a number of nodes; null if it is not known.
const ExodusType* exodusTypeNamed(std::string_view name, std::size_t nodes);

/// Returns the sides of a cell by the places of their corners, in the order of their numbers: faces of cells
/// of space, edges of others.
std::vector<std::vector<int>> exodusSidesOf(CellKind kind);

/// The side of an element that represents a cell of the dimension below, both from 0; −1 where none does.
struct ExodusSide {
    int element, side;
};
/// Returns it for every cell: only such cells can be in side sets, where they have no values.
std::vector<ExodusSide> sidesInExodus(const MeshFile& mesh);

}  // namespace wend::formats
