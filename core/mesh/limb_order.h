#pragma once

#include <vector>

#include "core/mesh/simplicial_mesh.h"

namespace wend {

/// Returns the position of every cell in an order of painting, from 0 (behind everything) to cells − 1. In
/// this order limbs are entirely in front of or behind what they cross where a planar shape covers itself.
///
/// Let d be the distance of a cell to the boundary and D its maximum in a set of cells. The body of the set
/// is what is covered by discs about the cells with d ≥ 0.8 D, each of radius d + 0.2 D, and about those on
/// the shortest way between two pieces of these cells that is no longer than 0.8 D. The rest falls into
/// connected parts. A part that reaches out by more than 0.4 D, and by more than a tenth of its component's
/// reach, is a limb and is decomposed in the same manner; other parts belong to the body. A limb thus begins
/// where it leaves its body, whatever its length.
///
/// A limb and everything that grows from it take consecutive positions, after the body that it grows from:
/// any two cells of one limb are on the same side of another limb. Of limbs that grow from one body, the
/// thinner ones are in front; of equally thin ones, those that reach farther. Only a body that is nearly as
/// thick as the one it grows from, and has several limbs, does not hold these together: arms on a chest that
/// grows from a belly are also in front of legs.
///
/// Within a body, branches of the join tree of the reach (Carr, Snoeyink, Axen 2003) are kept together in the
/// same manner; within one branch, cells that reach farther are in front. Components are painted in the order
/// of their first cells.
std::vector<int> limbOrder(const SimplicialMesh<2>& mesh);

}  // namespace wend
