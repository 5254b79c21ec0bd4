#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/mesh/cell_kind.h"

namespace wend::formats {

/// Returns the kind of cell of an element type such as "C3D8R"; nothing for types that are not cells of a
/// mesh, such as "MASS".
std::optional<CellKind> abaqusKind(std::string_view type);
/// Returns the plain element type of a kind; null for kinds that Abaqus does not have.
const char* abaqusType(CellKind kind);

/// Returns a number in at most 20 characters, as Abaqus reads them, with all digits if they fit.
std::string abaqusNumber(double value);

}  // namespace wend::formats
