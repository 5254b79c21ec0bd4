#pragma once

#include "core/mesh/mesh_file.h"

namespace wend::formats {

/// Returns the fields of a bag as VTK's formats and UCD write them; those per cell have the values of all
/// cells in `values`. Groups that no field represents become one field: "label" for the generated boundary of
/// a volume, with 0 in its tetrahedra, else "group".
std::vector<MeshField> vtkFieldsOf(const MeshFile& bag);

/// Returns the numbers of a field whose type is that whole number of eight bytes (std::int64_t or
/// std::uint64_t), all digits of them. Empty for other types, and where a number is outside its range.
template <class Whole>
std::vector<Whole> longNumbers(const MeshField& field);

}  // namespace wend::formats
