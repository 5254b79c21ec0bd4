#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/mesh/types.h"

namespace wend {

struct MeshFile;

/// Vertices that cells of a file name and its triangles or tetrahedra do not: nodes between corners, and
/// those of lines and vertices that stand apart.
std::vector<int> carriedNodes(const MeshFile& file);

/// True if a file has cells that are not its triangles or tetrahedra themselves.
bool hasWholeCells(const MeshFile& file);

/// How many cells of each kind a file has: "hexahedra", 12. Empty where all are its triangles or tetrahedra.
std::vector<std::pair<std::string, int>> cellCounts(const MeshFile& file);

/// The least corner Jacobian of each of a file's cells of its highest dimension, with the vertices at
/// `points`: det[x1 − x0, …] of the edges that leave a corner, divided by the product of their lengths (P.
/// Knupp, Achieving Finite Element Mesh Quality via Optimization of the Jacobian Matrix Norm, 2000). In [−1,
/// 1]; of polygons and other cells 1.
std::vector<double> cornerJacobians(const MeshFile& file, const Points<3>& points);

/// What a user should hear of cells whose corner Jacobian changes its sign from the file's points to these:
/// "2 of 40 hexahedra are turned over at a corner, the first cell 7"; empty if there are none.
std::string turnedCells(const MeshFile& file, const Points<3>& points);

}  // namespace wend
