#pragma once

#include <initializer_list>
#include <optional>

#include "core/mesh/mesh_file.h"

namespace wend::formats {

/// The cells of a file that are the mesh's: its tetrahedra if it has any, else its triangles.
int cellCount(const MeshFile& file);
/// The first of these fields that the file has with one component per cell, or null.
const MeshField* cellField(const MeshFile& file, std::initializer_list<const char*> names);
/// Its value for a cell as a whole number, or `otherwise` if there is no field.
long tagOf(const MeshField* field, int cell, long otherwise);

/// A mesh as printers take it: all its cells in `cells`, a value of every field per cell for each of them,
/// and groups. Cells that were made here are listed tetrahedra first, or `trianglesFirst`. Values that were
/// computed for the tetrahedra or triangles become those of the cells they were split from (their mean); the
/// boundary of a volume has those of the cells behind it, and NaN where there is none.
MeshFile bagOf(MeshFile mesh, bool trianglesFirst);

/// Adds the triangles of a volume's boundary, which must have none, as cells of a group "boundary".
MeshFile withBoundary(MeshFile mesh);

/// Adds groups for the numbers in a file whose format has no groups: those of the first field that is usual
/// for it, "physical", "ref", "attribute" or "material", and for cells of the plane those of "label". Called
/// before finishCells.
void addGroupsOfFields(MeshFile& file);

/// For every cell the group that stands for it where only one can: of those with a number the first, else the
/// first; −1 without one.
std::vector<int> mainGroups(const MeshFile& bag);

/// For every cell the number of that group, 0 without one. Groups that have a name only, but for Medit's
/// lists, get numbers behind all others.
std::vector<long> groupNumbers(const MeshFile& bag);

/// What the groups of a surface are as labels: a number per triangle, 0 for none, and the names of 1, 2, ….
struct SurfaceLabels {
    std::vector<int> labels;
    std::vector<std::string> names;
};
SurfaceLabels surfaceLabels(const MeshFile& file);

}  // namespace wend::formats
