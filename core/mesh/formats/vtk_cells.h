#pragma once

#include <cstdint>
#include <vector>

#include "core/mesh/cell_list.h"

namespace wend::formats {

/// VTK's cells in the layout of .vtu: cell c of types[c] has the corners connectivity[offsets[c] … offsets[c
/// + 1] − 1].
struct VtkCells {
    std::vector<std::int64_t> types, offsets, connectivity;
};

/// Adds them to the list; pixels and voxels become quadrilaterals and hexahedra. `firstVertex` is added to
/// all vertices, of which there are `vertexCount`. Throws InputError that names the cell for kinds that are
/// not read and for anything out of range.
void collect(const VtkCells& cells, long vertexCount, int firstVertex, CellList& list);

VtkCells vtkCellsOf(const CellList& list);

}  // namespace wend::formats
