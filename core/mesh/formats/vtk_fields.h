#pragma once

#include "core/mesh/mesh_file.h"

namespace wend::formats {

/// The fields of a bag as VTK's formats and UCD write them, those per cell with their values of all cells in
/// `values`. Groups that no field tells become one: "label" of a volume's boundary that was made, 0 in its
/// tetrahedra, else "group".
std::vector<MeshField> vtkFieldsOf(const MeshFile& bag);

}  // namespace wend::formats
