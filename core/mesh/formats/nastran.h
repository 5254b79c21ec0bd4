#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "core/mesh/cell_kind.h"

namespace wend::formats {

/// One entry of bulk data: a name and its fields, of all lines that it takes.
struct NastranCard {
    std::string name;  // upper case, without an asterisk
    std::vector<std::string> fields;
    std::size_t begin, end;  // of its lines in the file
};

/// Reads the entry at `at` and moves `at` behind it. Lines that are not an entry give one without a name.
NastranCard takeNastranCard(std::string_view bytes, std::size_t& at);

/// An element of Nastran. `order[k]` is the position of VTK's node k in Nastran's list; it is empty if both
/// orders agree.
struct NastranElement {
    std::string_view name;
    CellKind kind;
    std::vector<int> order;
};
/// Returns the elements that are read and written.
const std::vector<NastranElement>& nastranElements();

/// Returns a number in 16 characters, with as many digits as fit.
std::string nastranNumber(double value);
/// Returns a GRID entry of two lines, with fields of 16 characters, that has the given place and keeps
/// everything else of `old`.
std::string nastranGrid(const NastranCard& old, const double* point);

}  // namespace wend::formats
