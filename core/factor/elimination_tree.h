#pragma once

#include <vector>

#include "core/factor/supernodes.h"

namespace wend {

/// The elimination tree of a factor's supernodes (Liu 1990), which are numbered in postorder, split for
/// several threads: the subtrees are independent of each other, and the separator consists of their
/// ancestors. The split depends on the pattern alone.
struct EliminationTree {
    /// The supernodes [begin, end) of a subtree, which are consecutive.
    struct Subtree {
        int begin, end;  // supernodes; the last one is the root
        int root() const { return end - 1; }
    };

    std::vector<int> parent;                 // per supernode: where the first row below belongs; −1: a root
    std::vector<std::vector<int>> children;  // in elimination order
    std::vector<Subtree> subtrees;           // those with most work first
    std::vector<int> separator;              // in elimination order
};

/// Returns the tree of a symbolic factor. The parent of a supernode owns the first row below its own columns.
/// The work of a supernode with c columns and r rows is taken as (c + 32) r²: c r² multiplications of its
/// front, and the moves of its entries, each worth about 32 of them. The subtrees are the largest ones that
/// hold at most 15 % of all work each; supernodes with more work at and below them form the separator. This
/// leaves enough subtrees for several threads to end at about the same time, and a short separator. The
/// number of threads has no influence, so that results do not depend on it. Takes time linear in the number
/// of unknowns, but for a sort of the subtrees; an empty factor gives an empty tree.
EliminationTree makeEliminationTree(const Supernodes& symbolic);

}  // namespace wend
