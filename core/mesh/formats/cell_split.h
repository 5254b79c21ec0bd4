#pragma once

#include <functional>

#include "core/mesh/mesh_file.h"

namespace wend::formats {

/// Returns tetrahedra that fill a cell of space, by its corners; nodes between them are left out. Every face
/// is split from its vertex of the smallest number, and so is the cell, so that neighbours agree (J.
/// Dompierre et al., How to Subdivide Pyramids, Prisms and Hexahedra into Tetrahedra, 1999). Tetrahedra that
/// name a vertex twice are left out. A cell in its usual numbering gives positive ones.
std::vector<std::array<int, 4>> splitCell(CellKind kind, std::span<const int> nodes);

/// Completes the reading of a file whose `cells` and points are known: makes triangles and tetrahedra of the
/// cells, labels of the groups, and turns the fields per cell, which have values for all cells, into those of
/// the triangles or tetrahedra. `place` names a cell in errors. Throws InputError.
void finishCells(MeshFile& file, const std::function<std::string(int cell)>& place = {});

/// Adds a group for each nonzero number of a field per cell, in every dimension of cells. It is called before
/// finishCells; names are looked up by (dimension, number).
void addGroups(MeshFile& file, const std::vector<double>& numbers,
               const std::function<std::string(int dimension, long tag)>& name = {});

}  // namespace wend::formats
