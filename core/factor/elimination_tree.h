#pragma once

#include <vector>

#include "core/factor/supernodes.h"

namespace wend {

/// The elimination tree of a factor's supernodes (Liu 1990), which are numbered in postorder, and how several
/// threads share it: each of the subtrees needs nothing of the others, the separator is what lies above
/// them. The split follows from the pattern alone.
struct EliminationTree {
    struct Subtree {
        int begin, end;  // supernodes; the last one is the root
        int root() const { return end - 1; }
    };

    std::vector<int> parent;                 // per supernode: where the first row below belongs; −1: a root
    std::vector<std::vector<int>> children;  // in elimination order
    std::vector<Subtree> subtrees;           // those with most work first
    std::vector<int> separator;              // in elimination order
};

EliminationTree makeEliminationTree(const Supernodes& symbolic);

}  // namespace wend
