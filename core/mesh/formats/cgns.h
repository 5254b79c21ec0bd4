#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "core/mesh/cell_kind.h"

namespace wend::formats {

/// A type of element in CGNS files: its number, and for each node in VTK's order its place there.
struct CgnsType {
    int number;
    CellKind kind;
    std::vector<int> order;  // empty: the same
};
/// Returns the table of types.
std::span<const CgnsType> cgnsTypes();
/// Returns the type of a kind of cell.
const CgnsType& cgnsTypeOf(CellKind kind);

/// The type of sections whose cells have types of their own, and the lengths of names and of labels.
inline constexpr int kCgnsMixed = 20, kCgnsName = 32;

}  // namespace wend::formats
