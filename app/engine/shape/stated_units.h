#pragma once

#include <string>

namespace wend {

/// Returns the unit of length that a mesh file names in a comment of its head ("# units: mm", "comment unit
/// inch", "UNITS=cm" in the head of an STL file), or in the model of a 3MF file: "mm", "cm", "m", "in", "ft"
/// or "µm"; empty if it names none, which is usual.
std::string statedUnits(const std::string& path);

}  // namespace wend
