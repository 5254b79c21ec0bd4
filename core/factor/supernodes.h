#pragma once

#include <vector>

namespace wend {

/// The symbolic analysis of a sparse Cholesky factor. Its columns, in elimination order, form groups that
/// share one pattern below a dense triangle. Panel s is dense with rowsOf(s) × columnsOf(s) entries, of which
/// those above the diagonal do not count.
struct Supernodes {
    std::vector<int> order;     // elimination step → unknown
    std::vector<int> first;     // per supernode, and the end: its first column
    std::vector<int> rowStart;  // per supernode, and the end: where its rows begin …
    std::vector<int> rows;      // … its own columns, then those below, ascending

    int count() const { return static_cast<int>(first.size()) - 1; }
    int columnsOf(int s) const { return first[s + 1] - first[s]; }
    int rowsOf(int s) const { return rowStart[s + 1] - rowStart[s]; }
};

}  // namespace wend
