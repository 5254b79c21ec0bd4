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

/// Returns the tree of a symbolic factor. Subtrees are chosen by their estimated work, the floating-point
/// operations of factorizing their supernodes, so that results do not depend on the number of threads.
EliminationTree makeEliminationTree(const Supernodes& symbolic);

}  // namespace wend
