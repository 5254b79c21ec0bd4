#include "core/factor/elimination_tree.h"

#include <algorithm>

namespace wend {
namespace {

// Enough subtrees for several threads to end at about the same time; more of them would make the separator
// long.
constexpr double kMaxShare = 0.15;
// An entry of a front is moved about as often as this many multiplications are done.
constexpr double kEntryCost = 32;

/// Finds the parent of every supernode, which owns the first row below it, and the children of every parent.
void connect(const Supernodes& symbolic, EliminationTree& tree) {
    const int count = symbolic.count();
    std::vector<int> owner(symbolic.order.size());
    for (int s = 0; s < count; ++s)
        std::fill(owner.begin() + symbolic.first[s], owner.begin() + symbolic.first[s + 1], s);
    tree.parent.assign(count, -1);
    tree.children.resize(count);
    for (int s = 0; s < count; ++s) {
        const int columns = symbolic.columnsOf(s);
        if (symbolic.rowsOf(s) == columns) continue;
        tree.parent[s] = owner[symbolic.rows[symbolic.rowStart[s] + columns]];
        tree.children[tree.parent[s]].push_back(s);
    }
}

/// Returns the work on every supernode and all below it.
std::vector<double> workOfSubtrees(const Supernodes& symbolic, const EliminationTree& tree) {
    std::vector<double> work(symbolic.count(), 0.0);
    for (int s = 0; s < symbolic.count(); ++s) {
        const double rows = symbolic.rowsOf(s);
        work[s] += (symbolic.columnsOf(s) + kEntryCost) * rows * rows;
        if (tree.parent[s] >= 0) work[tree.parent[s]] += work[s];
    }
    return work;
}

/// Divides the tree: a supernode whose subtree holds more than kMaxShare of all work belongs to the
/// separator, and one that holds no more, but whose parent does (or that is a root), is the root of a
/// subtree. The postorder makes the supernodes of a subtree consecutive, from its first descendant on. The
/// largest subtrees come first, because threads take them in this order and a large one at the end would keep
/// the others waiting.
void split(const std::vector<double>& work, EliminationTree& tree) {
    const int count = static_cast<int>(work.size());
    double total = 0;
    std::vector<int> first(count);  // of the subtree
    for (int s = 0; s < count; ++s) {
        first[s] = tree.children[s].empty() ? s : first[tree.children[s].front()];
        if (tree.parent[s] < 0) total += work[s];
    }
    const double maximum = kMaxShare * total;
    for (int s = 0; s < count; ++s) {
        const int parent = tree.parent[s];
        if (work[s] > maximum)
            tree.separator.push_back(s);
        else if (parent < 0 || work[parent] > maximum)
            tree.subtrees.push_back({first[s], s + 1});
    }
    std::stable_sort(tree.subtrees.begin(), tree.subtrees.end(),
                     [&](const auto& a, const auto& b) { return work[a.root()] > work[b.root()]; });
}

}  // namespace

EliminationTree makeEliminationTree(const Supernodes& symbolic) {
    EliminationTree tree;
    connect(symbolic, tree);
    split(workOfSubtrees(symbolic, tree), tree);
    return tree;
}

}  // namespace wend
