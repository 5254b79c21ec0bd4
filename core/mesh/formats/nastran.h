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

/// Takes the entry at `at`, which it moves behind it; lines that are none give an entry without a name.
NastranCard takeNastranCard(std::string_view bytes, std::size_t& at);

/// `order[k]` is where VTK's node k stands in Nastran's list; empty: they agree.
struct NastranElement {
    std::string_view name;
    CellKind kind;
    std::vector<int> order;
};
const std::vector<NastranElement>& nastranElements();

/// A number in 16 characters, as many digits as these hold.
std::string nastranNumber(double value);
/// A GRID entry of two lines, fields of 16 characters, that keeps what is not its place.
std::string nastranGrid(const NastranCard& old, const double* point);

}  // namespace wend::formats
