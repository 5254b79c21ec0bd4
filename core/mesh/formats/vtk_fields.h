#pragma once

#include "core/mesh/formats/cell_collector.h"
#include "core/mesh/formats/vtk_cells.h"

namespace wend::formats {

/// What both VTK formats write: the mesh's cells, and behind the tetrahedra the triangles of their boundary,
/// if there are any.
VtkCells vtkCellsOf(const MeshFile& mesh);
/// The mesh's fields with a value for each of these cells: the triangles of the boundary have those of the
/// tetrahedra behind them. The field "label" is the boundary's, and 0 in the tetrahedra.
std::vector<MeshField> vtkFieldsOf(const MeshFile& mesh);

/// The other way: takes the labels of the boundary out of the field "label", and the field away if its
/// tetrahedra have none. `values` are those of the field for all of the file's elements.
void takeVtkLabels(const MeshField& field, const CellCollector& collector, MeshFile& file);
/// True for that field.
bool isVtkLabels(const MeshField& field);

}  // namespace wend::formats
