#pragma once

#include <vector>

#include "core/mesh/simplicial_mesh.h"

namespace wend {

/// The place of every cell in an order of painting, from 0 (behind everything) to cells − 1, in which limbs
/// lie whole over what they cross where a shape in the plane covers itself.
///
/// Let d be the distance of a cell to the boundary and D its maximum in a set of cells. The set's body is
/// what discs about the cells with d ≥ 0.8 D cover, each of radius d + 0.2 D. What remains falls into
/// connected parts: a part that reaches out by more than 0.4 D, and by more than a tenth of its component's
/// reach, is a limb, and so decomposed in its turn; other parts belong to the body. A limb thus begins where
/// it leaves its body, whatever its length.
///
/// A limb and all that grows from it take consecutive places, after the body that it grows from: any two
/// places of one limb lie on the same side of another limb. Of limbs that grow from one body the thinner ones
/// lie in front, of equally thin ones those that reach farther. Only a body that is nearly as thick as the
/// one it grows from, and has several limbs, does not hold these together: arms on a chest that grows from a
/// belly lie over legs, too.
///
/// Within a body, branches of the join tree of the reach (Carr, Snoeyink, Axen 2003) are kept together in the
/// same way; in one branch, what reaches farther lies in front. Components lie over one another in the order
/// of their first cells.
std::vector<int> limbOrder(const SimplicialMesh<2>& mesh);

}  // namespace wend
