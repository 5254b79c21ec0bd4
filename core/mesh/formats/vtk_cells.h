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

/// Adds the cells to a list; pixels and voxels become quadrilaterals and hexahedra. `firstVertex` is added to
/// all vertices, of which there are `vertexCount`. Throws InputError that names the cell for kinds that are
/// not read and for anything out of range.
void collect(const VtkCells& cells, long vertexCount, int firstVertex, CellList& list);

/// Returns the cells of a list in VTK's layout.
VtkCells vtkCellsOf(const CellList& list);

/// A section of a .vtp file.
struct PolySection {
    const char *name, *count;   // of the element, and of the attribute with the number of its cells
    int few, one, other, many;  // VTK's types of cells with up to `few` nodes, with `few` + 1, and with more

    /// Returns VTK's type of a cell with that many nodes.
    int typeOf(std::int64_t nodes) const { return nodes <= few ? one : nodes == few + 1 ? other : many; }
};
/// The sections in the order of their values in the file.
constexpr PolySection kPolySections[] = {{"Verts", "NumberOfVerts", 1, 1, 2, 2},
                                         {"Lines", "NumberOfLines", 2, 3, 4, 4},
                                         {"Strips", "NumberOfStrips", 3, 6, 6, 6},
                                         {"Polys", "NumberOfPolys", 3, 5, 9, 7}};
/// Returns the number of the section with such cells.
int polySectionOf(CellKind kind);

}  // namespace wend::formats
