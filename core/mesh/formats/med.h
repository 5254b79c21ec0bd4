#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "core/mesh/cell_kind.h"

namespace wend::formats {

/// A type of cell in MED files: its name there, its number, and for each node in VTK's order its place there.
struct MedType {
    std::string_view name;
    int number;
    CellKind kind;
    std::vector<int> order;  // empty: the same
};
/// Returns the table of types.
std::span<const MedType> medTypes();

/// The name of what holds for all cells, and the ends of texts in MED files.
inline constexpr std::string_view kMedNoProfile = "MED_NO_PROFILE_INTERNAL";
inline constexpr int kMedGroupName = 80, kMedName = 64, kMedShortName = 16;

}  // namespace wend::formats
