#pragma once

#include <initializer_list>
#include <optional>

#include "core/mesh/mesh_file.h"

namespace wend::formats {

/// Returns the number of cells of the mesh in a file: its tetrahedra if it has any, else its triangles.
int cellCount(const MeshFile& file);
/// Returns the first of these fields that the file has with one component per cell, or null.
const MeshField* cellField(const MeshFile& file, std::initializer_list<const char*> names);
/// Returns the value of a field for a cell as a whole number, or `otherwise` if there is no field.
long tagOf(const MeshField* field, int cell, long otherwise);

/// Returns the index of a node of the next cell, which the file counts from 1. Throws InputError if the file
/// has no such node.
int nodeOf(const MeshFile& file, std::int64_t number);
/// Joins three fields in a row to a vector if their names are equal but for their ends, `before` and then one
/// of three `letters` in order: "u_x", "u_y", "u_z" become "u" with "_" and "xyz".
void joinVectors(MeshFile& file, std::string_view before, std::string_view letters);

/// Sets the texture coordinates of a file whose cells are complete, from u and v of every node of every cell
/// (NaN where there is none): `uv` if every corner of a face has some, with (0, 0) at vertices without a
/// face, and `cornerUv` if those are not all that there is.
void setCornerUv(MeshFile& file, std::vector<double> cornerUv);

/// Returns a mesh as printers take it: all its cells in `cells`, a value of every field per cell for each of
/// them, and groups. Generated cells are listed tetrahedra first, or `trianglesFirst`. Values that were
/// computed for the tetrahedra or triangles become those of the cells that they were split from (their mean);
/// the boundary of a volume has those of the cells behind it, and NaN where there is none.
MeshFile bagOf(MeshFile mesh, bool trianglesFirst);

/// Adds the triangles of a volume's boundary, which must have none, as cells of a group "boundary".
MeshFile withBoundary(MeshFile mesh);

/// Adds groups for the numbers in a file whose format has no groups: those of the first field that is usual
/// for them, "physical", "ref", "attribute" or "material", and for cells of the plane those of "label". It is
/// called before finishCells.
void addGroupsOfFields(MeshFile& file);

/// Returns the bag with its cells in another order: the new cell i is the old order[i].
MeshFile inOrder(const MeshFile& mesh, const std::vector<int>& order);

/// Names a group as a format whose groups have names alone does: a name that is a number is one.
void nameGroup(const std::string& name, MeshGroup& group);
/// Returns the name of a group for such a format.
std::string groupName(const MeshGroup& group);

/// Returns for every cell the group that represents it where only one is possible: the first of those with a
/// number, else the first; −1 if it has none.
std::vector<int> mainGroups(const MeshFile& bag);

/// Returns for every cell the number of that group, 0 if it has none. Groups that have a name only, except
/// Medit's lists, get numbers behind all others.
std::vector<long> groupNumbers(const MeshFile& bag);

/// The groups of a surface as labels: a number per triangle, 0 for none, and the names of 1, 2, ….
struct SurfaceLabels {
    std::vector<int> labels;
    std::vector<std::string> names;
};
/// Returns the groups of a surface as labels.
SurfaceLabels surfaceLabels(const MeshFile& file);

}  // namespace wend::formats
