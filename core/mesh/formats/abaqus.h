#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/mesh/cell_kind.h"

namespace wend::formats {

/// The kind of cell of an element type such as "C3D8R"; nothing for types that are no cells of a mesh, such
/// as "MASS".
std::optional<CellKind> abaqusKind(std::string_view type);
/// The plain element type of a kind; null for kinds that Abaqus has not.
const char* abaqusType(CellKind kind);

/// A number in at most 20 characters, as Abaqus reads them: all digits where they fit.
std::string abaqusNumber(double value);

}  // namespace wend::formats
