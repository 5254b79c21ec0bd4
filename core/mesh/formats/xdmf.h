#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "core/mesh/cell_kind.h"

namespace wend::formats {

/// A topology of XDMF files: its name, another one that is in use, its number in mixed topologies.
struct XdmfTopology {
    std::string_view name, other;
    int number;
    CellKind kind;
};
/// Returns the table of topologies.
std::span<const XdmfTopology> xdmfTopologies();

/// The name of the field with the numbers of groups, where no other field has these.
inline constexpr const char* kXdmfGroups = "group";

/// The numbers of topologies whose cells tell in mixed ones how many nodes they have.
inline constexpr int kXdmfVertex = 1, kXdmfLine = 2, kXdmfPolygon = 3;

}  // namespace wend::formats
