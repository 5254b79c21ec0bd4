#pragma once

#include <vector>

#include "core/solver/supernodes.h"

namespace wend {

/// The elimination tree of a factor's supernodes (Liu 1990), which are numbered in postorder, and how several
/// threads share it: branches are whole subtrees that need nothing of each other, the trunk is what lies
/// above them. The split follows from the pattern alone.
struct EliminationTree {
    struct Branch {
        int begin, end;  // the subtree of end − 1
        int root() const { return end - 1; }
    };

    std::vector<int> parent;                 // per supernode: where the first row below belongs; −1: a root
    std::vector<std::vector<int>> children;  // in elimination order
    std::vector<Branch> branches;            // those with most work first
    std::vector<int> trunk;                  // in elimination order
};

EliminationTree makeEliminationTree(const Supernodes& symbolic);

}  // namespace wend
