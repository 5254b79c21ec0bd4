#pragma once

#include "core/mesh/formats/cell_collector.h"
#include "core/mesh/formats/vtk_cells.h"

namespace wend::formats {

/// What both VTK formats write: the mesh's cells, and behind the tetrahedra the triangles of their border, if
/// there are any; these have 0 in every field, since MeshFile has no values for them.
VtkCells vtkCellsOf(const MeshFile& mesh);
std::vector<double> vtkValuesOf(const MeshField& field, const VtkCells& cells);

}  // namespace wend::formats
