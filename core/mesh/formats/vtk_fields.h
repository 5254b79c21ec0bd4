#pragma once

#include "core/mesh/formats/cell_collector.h"
#include "core/mesh/formats/vtk_cells.h"

namespace wend::formats {

/// What both VTK formats write: the mesh's cells, and behind the tetrahedra the triangles of their border, if
/// there are any; these have 0 in every field, since MeshFile has no values for them, but for the field
/// "label", which has those of the border (and 0 in the tetrahedra).
VtkCells vtkCellsOf(const MeshFile& mesh);
std::vector<double> vtkValuesOf(const MeshField& field, const VtkCells& cells);
/// The mesh's fields with that one.
std::vector<MeshField> vtkFieldsOf(const MeshFile& mesh);

/// The other way: takes the labels of the border out of the field "label", and the field away if its
/// tetrahedra have none. `values` are those of the field for all of the file's elements.
void takeVtkLabels(const MeshField& field, const CellCollector& collector, MeshFile& file);
/// True for that field.
bool isVtkLabels(const MeshField& field);

}  // namespace wend::formats
