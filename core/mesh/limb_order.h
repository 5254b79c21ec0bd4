#pragma once

#include <vector>

#include "core/mesh/simplicial_mesh.h"

namespace wend {

/// Where a shape in the plane covers itself, its limbs are to be seen whole. The place of every cell in an
/// order of painting that does so, from 0 (behind everything) to cells − 1.
///
/// The reach of a cell is its distance, through the shape, from the middle of its connected component: from
/// the cell that is farthest from the boundary. Limbs are the branches of the join tree of the reach (Carr,
/// Snoeyink, Axen 2003) that stand out by more than a tenth of the largest reach; what stands out less
/// belongs to the branch that it meets. A limb lies over the one that it grows from; of two that grow from
/// one, the one with the farther tip lies in front, with all that grows from it; in one limb, what reaches
/// farther. Components lie over one another in the order of their first cells.
std::vector<int> limbOrder(const SimplicialMesh<2>& mesh);

}  // namespace wend
