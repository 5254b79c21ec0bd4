#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/base/types.h"

namespace wend {

struct MeshFile;

/// Returns the vertices that the file's cells use but its triangles and tetrahedra do not: nodes between
/// corners, and those of separate lines and vertices.
std::vector<int> carriedNodes(const MeshFile& file);

/// Returns whether a file has cells that are not its triangles or tetrahedra themselves.
bool hasWholeCells(const MeshFile& file);

/// Counts the cells of each kind in a file, as "hexahedra", 12. Returns nothing if all are its triangles or
/// tetrahedra.
std::vector<std::pair<std::string, int>> cellCounts(const MeshFile& file);

/// Returns the least corner Jacobian of each of a file's cells of its highest dimension, with the vertices at
/// `points`: det[x1 − x0, …] of the edges that leave a corner, divided by the product of their lengths (P.
/// Knupp, Achieving Finite Element Mesh Quality via Optimization of the Jacobian Matrix Norm, 2000). It is in
/// [−1, 1], and 1 for polygons and other cells.
std::vector<double> cornerJacobians(const MeshFile& file, const Points3& points);

/// Describes, for the user, the cells whose corner Jacobian changes its sign from the file's points to these:
/// "2 of 40 cells are turned over at a corner, the first cell 7"; empty if there are none.
std::string turnedCells(const MeshFile& file, const Points3& points);

}  // namespace wend
