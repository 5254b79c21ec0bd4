#pragma once

#include "core/mesh/formats/cell_collector.h"

namespace wend::formats {

/// The cell types of VTK that meshes of triangles and tetrahedra are made of.
constexpr int vtkTriangle = 5, vtkTetrahedron = 10;

/// VTK's cells in the layout of .vtu: cell c of types[c] has the corners connectivity[offsets[c] … offsets[c
/// + 1] − 1].
struct VtkCells {
    std::vector<std::int64_t> types, offsets, connectivity;
};

/// Adds them to the collector as elements first, first + 1, …; points and lines are passed over. Throws
/// InputError that names the cell for kinds that are not read and for anything out of range.
void collect(const VtkCells& cells, Eigen::Index vertexCount, int first, CellCollector& collector);

}  // namespace wend::formats
