#include <algorithm>
#include <cmath>

#include "core/factor/dense_kernels.h"
#include "core/factor/supernodal_factor.h"

namespace wend {
namespace {

// A panel of fewer numbers is left to one thread.
constexpr std::size_t kSharedPanel = 100000;
constexpr int kRows = 512, kColumns = 2 * dense::kSolveColumns;  // of a piece

// Numbers go to and from the places in a list one by one or in pairs, kStep at a time.

/// Gathers numbers of x.
template <int kStep, class Real>
void gather(const Real* x, const int* index, int count, Real* to) {
    for (int i = 0; i < count; i += kStep) std::copy_n(x + index[i], kStep, to + i);
}

/// Adds numbers to those of x.
template <int kStep, class Real>
void scatter(const Real* from, const int* index, int count, Real* x) {
    for (int i = 0; i < count; i += kStep) {
        Real sum[kStep];
        for (int k = 0; k < kStep; ++k) sum[k] = x[index[i] + k] + from[i + k];
        std::copy_n(sum, kStep, x + index[i]);
    }
}

/// Brings the numbers of b into an order, times a factor.
template <int kStep, class Real>
void reorder(std::span<const double> b, double factor, const std::vector<int>& order, Real* x) {
    for (std::size_t i = 0; i < order.size(); i += kStep)
        for (std::size_t k = 0; k < kStep; ++k) x[i + k] = static_cast<Real>(factor * b[order[i] + k]);
}

/// Brings them back from it.
template <int kStep, class Real>
void putBack(const Real* x, double factor, const std::vector<int>& order, std::span<double> to) {
    for (std::size_t i = 0; i < order.size(); i += kStep)
        for (std::size_t k = 0; k < kStep; ++k) to[order[i] + k] = factor * x[i + k];
}

/// Returns whether the unknowns come in pairs, as those of the vertices in the plane do: two columns and two
/// rows each. Two numbers are then copied at a time.
bool comeInPairs(const Supernodes& symbolic) {
    const auto isEven = [](int number) { return number % 2 == 0; };
    const auto arePairs = [](const std::vector<int>& numbers) {
        for (std::size_t i = 0; i + 1 < numbers.size(); i += 2)
            if (numbers[i + 1] != numbers[i] + 1) return false;
        return true;
    };
    return std::ranges::all_of(symbolic.first, isEven) && std::ranges::all_of(symbolic.rowStart, isEven) &&
           arePairs(symbolic.rows) && arePairs(symbolic.order);
}

bool isShared(int leading, int columns) {
    return static_cast<std::size_t>(leading) * columns >= kSharedPanel;
}

}  // namespace

/// Rows above a subtree have places of its own, so that subtrees may be done at the same time; they are added
/// up in a fixed order.
template <class Real>
void SupernodalFactor<Real>::placeWorkspaces() {
    const auto maximum = [&](auto begin, auto end) {
        std::size_t most = 0;
        for (; begin != end; ++begin) most = std::max(most, static_cast<std::size_t>(leading(*begin)));
        return most + dense::kPad<Real>;
    };
    m_isPaired = comeInPairs(m_symbolic);
    m_target = m_symbolic.rows;
    std::size_t x = m_symbolic.order.size(), w = 0;
    std::vector<int> place(x), group;
    for (const auto& subtree : m_tree.subtrees) {
        group.clear();
        for (int s = subtree.begin; s < subtree.end; ++s) group.push_back(s);
        m_workspace.push_back(w);
        w += maximum(group.begin(), group.end());
        m_contribution.push_back(x);
        const int root = subtree.root(), end = m_symbolic.first[subtree.end];
        for (int i = m_symbolic.rowStart[root] + m_symbolic.columnsOf(root);
             i < m_symbolic.rowStart[root + 1]; ++i)
            place[m_symbolic.rows[i]] = static_cast<int>(x++);
        for (int i = m_symbolic.rowStart[subtree.begin]; i < m_symbolic.rowStart[subtree.end]; ++i)
            if (m_target[i] >= end) m_target[i] = place[m_target[i]];
    }
    m_workspace.push_back(w);
    m_w.resize(w + maximum(m_tree.separator.begin(), m_tree.separator.end()));
    m_x.resize(x);
}

/// Solves forward with one front: takes its part of x, applies the panel, and adds the result to the rows
/// below. A large panel of the separator is shared: its triangle comes first, in one thread.
template <class Real>
void SupernodalFactor<Real>::forwardFront(int s, Real* w, WorkerPool* workers) {
    const int columns = m_symbolic.columnsOf(s), rows = m_symbolic.rowsOf(s), n = leading(s);
    const int* const target = m_target.data() + m_symbolic.rowStart[s];
    Real* const x = m_x.data() + m_symbolic.first[s];
    std::copy_n(x, columns, w);
    std::fill(w + columns, w + n, Real(0));
    const bool shared = workers && isShared(n, columns);
    const int below = shared ? dense::padded<Real>(columns) : n;
    m_kernels->forward(panel(s), n, columns, below, w, x);
    if (shared)
        workers->forPieces(n - below, kRows, [&](int begin, int end) {
            m_kernels->continueForward(panel(s), n, columns, below + begin, below + end, w);
        });
    const auto put = m_isPaired ? scatter<2, Real> : scatter<1, Real>;
    put(w + columns, target + columns, rows - columns, m_x.data());
}

/// Solves backward with one front: gathers x in the rows below, and applies the transposed panel.
template <class Real>
void SupernodalFactor<Real>::backwardFront(int s, Real* w, WorkerPool* workers) {
    const int columns = m_symbolic.columnsOf(s), rows = m_symbolic.rowsOf(s), n = leading(s);
    const int* const index = m_symbolic.rows.data() + m_symbolic.rowStart[s];
    Real* const x = m_x.data() + m_symbolic.first[s];
    const auto take = m_isPaired ? gather<2, Real> : gather<1, Real>;
    take(m_x.data(), index, rows, w);
    std::fill(w + rows, w + n, Real(0));
    std::fill_n(x, columns, Real(0));
    const bool shared = workers && isShared(n, columns);
    const int below = shared ? dense::padded<Real>(columns) : n;
    if (shared)
        workers->forPieces(columns, kColumns, [&](int begin, int end) {
            m_kernels->prepareBackward(panel(s), n, begin, end, below, w, x);
        });
    m_kernels->backward(panel(s), n, columns, below, w, x);
}

template <class Real>
void SupernodalFactor<Real>::forwardSubtree(int i) {
    const auto& subtree = m_tree.subtrees[i];
    std::fill_n(m_x.begin() + static_cast<std::ptrdiff_t>(m_contribution[i]), updateRows(subtree.root()),
                Real(0));
    for (int s = subtree.begin; s < subtree.end; ++s) forwardFront(s, m_w.data() + m_workspace[i], nullptr);
}

/// Solves forward in the subtrees concurrently. Their contributions to the rows above are summed afterwards
/// in a fixed order, so that the result does not depend on the threads.
template <class Real>
void SupernodalFactor<Real>::forwardSolve(WorkerPool& workers) {
    const int subtrees = static_cast<int>(m_tree.subtrees.size());
    workers.forPieces(subtrees, 1, [&](int i, int) { forwardSubtree(i); });
    for (int i = 0; i < subtrees; ++i) {
        const int root = m_tree.subtrees[i].root();
        const int* const row =
            m_symbolic.rows.data() + m_symbolic.rowStart[root] + m_symbolic.columnsOf(root);
        for (int k = 0; k < updateRows(root); ++k) m_x[row[k]] += m_x[m_contribution[i] + k];
    }
    for (const int s : m_tree.separator) forwardFront(s, m_w.data() + m_workspace.back(), &workers);
}

/// Solves backward in the separator, and then in the subtrees concurrently: each reads x in the rows above
/// it, which are done, and writes its own rows only.
template <class Real>
void SupernodalFactor<Real>::backwardSolve(WorkerPool& workers) {
    for (auto s = m_tree.separator.rbegin(); s != m_tree.separator.rend(); ++s)
        backwardFront(*s, m_w.data() + m_workspace.back(), &workers);
    workers.forPieces(static_cast<int>(m_tree.subtrees.size()), 1, [&](int i, int) {
        const auto& subtree = m_tree.subtrees[i];
        for (int s = subtree.root(); s >= subtree.begin; --s)
            backwardFront(s, m_w.data() + m_workspace[i], nullptr);
    });
}

// Scaled to 1, so that the residuals of the last iterations stay in the range of single precision.
template <class Real>
bool SupernodalFactor<Real>::solve(std::span<const double> b, std::span<double> x, WorkerPool& workers) {
    double size = 0;
    for (double value : b) size = std::max(size, std::abs(value));
    const double back = size > 0 ? size : 1.0, scale = 1 / back;
    const auto& order = m_symbolic.order;
    m_isPaired ? reorder<2>(b, scale, order, m_x.data()) : reorder<1>(b, scale, order, m_x.data());
    forwardSolve(workers);
    backwardSolve(workers);
    bool finite = std::isfinite(size);
    for (std::size_t i = 0; i < order.size(); ++i) finite &= std::isfinite(m_x[i]);
    m_isPaired ? putBack<2>(m_x.data(), back, order, x) : putBack<1>(m_x.data(), back, order, x);
    return finite;
}

// The class is instantiated in supernodal_factor.cpp; here the functions that other files call.
template void SupernodalFactor<float>::placeWorkspaces();
template void SupernodalFactor<double>::placeWorkspaces();
template bool SupernodalFactor<float>::solve(std::span<const double>, std::span<double>, WorkerPool&);
template bool SupernodalFactor<double>::solve(std::span<const double>, std::span<double>, WorkerPool&);

}  // namespace wend
