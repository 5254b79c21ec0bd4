#include "core/solver/supernodal_factor.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/solver/dense_kernels.h"

namespace wend {
namespace {

/// Up to a whole number of cache lines.
template <class Real>
std::size_t padded(std::size_t count) {
    return (count + dense::kPad<Real> - 1) / dense::kPad<Real> * dense::kPad<Real>;
}

/// `count` zeros and slack behind them; returns the first that is aligned to a cache line.
template <class Real>
Real* allocate(std::vector<Real>& storage, std::size_t count) {
    storage.assign(count + dense::kPad<Real> + dense::kSlack, Real(0));
    const auto address = reinterpret_cast<std::uintptr_t>(storage.data());
    return storage.data() + (64 - address % 64) % 64 / sizeof(Real);
}

/// to += from.
template <class Real>
inline void add(Real* to, const Real* from, int count) {
    int i = 0;
    for (; i + 4 <= count; i += 4)
        for (int k = 0; k < 4; ++k) to[i + k] += from[i + k];
    for (; i < count; ++i) to[i] += from[i];
}

}  // namespace

template <class Real>
SupernodalFactor<Real>::SupernodalFactor(Supernodes symbolic, const std::vector<int>& columnStart,
                                         const std::vector<int>& row)
    : m_symbolic(std::move(symbolic)) {
    layOut();
    placeUpdates();
    mapUpdates();
    mapEntries(columnStart, row);
}

template <class Real>
int SupernodalFactor<Real>::leading(int s) const {
    return static_cast<int>(padded<Real>(m_symbolic.rowsOf(s)));
}

template <class Real>
int SupernodalFactor<Real>::updateLeading(int s) const {
    return static_cast<int>(padded<Real>(updateRows(s)));
}

/// Panels one after another; the elimination tree: the parent holds the first row below.
template <class Real>
void SupernodalFactor<Real>::layOut() {
    const int count = m_symbolic.count();
    const std::size_t unknowns = m_symbolic.order.size();
    std::vector<int> owner(unknowns);
    m_parent.assign(count, -1);
    m_children.resize(count);
    for (int s = 0; s < count; ++s)
        std::fill(owner.begin() + m_symbolic.first[s], owner.begin() + m_symbolic.first[s + 1], s);
    m_panelStart.assign(1, 0);
    int greatest = 0;
    for (int s = 0; s < count; ++s) {
        m_panelStart.push_back(m_panelStart.back() +
                               static_cast<std::size_t>(leading(s)) * m_symbolic.columnsOf(s));
        greatest = std::max(greatest, leading(s));
        if (updateRows(s) == 0) continue;
        m_parent[s] = owner[m_symbolic.rows[m_symbolic.rowStart[s] + m_symbolic.columnsOf(s)]];
        m_children[m_parent[s]].push_back(s);
    }
    // Kernels may look at eight columns from any place of the last panel.
    m_panels = allocate(m_storage, m_panelStart.back() + 8 * static_cast<std::size_t>(greatest));
    m_inverse.resize(unknowns);
    m_x.resize(unknowns);
    m_w.resize(static_cast<std::size_t>(greatest) + dense::kPad<Real>);
}

/// Follows both stacks through a factorization.
template <class Real>
void SupernodalFactor<Real>::placeUpdates() {
    const int count = m_symbolic.count();
    m_depth.assign(count, 0);
    m_updateStart.assign(count, 0);
    std::size_t top[2] = {0, 0}, most[2] = {0, 0};
    for (int s = count - 1; s >= 0; --s)
        if (m_parent[s] >= 0) m_depth[s] = m_depth[m_parent[s]] + 1;
    for (int s = 0; s < count; ++s) {
        const int own = m_depth[s] % 2;
        m_updateStart[s] = top[own];
        top[own] += static_cast<std::size_t>(updateLeading(s)) * updateRows(s);
        most[own] = std::max(most[own], top[own]);
        if (!m_children[s].empty()) top[1 - own] = m_updateStart[m_children[s].front()];
    }
    for (int i : {0, 1}) m_updates[i] = allocate(m_updateStorage[i], most[i]);
}

template <class Real>
void SupernodalFactor<Real>::mapUpdates() {
    std::vector<int> place(m_symbolic.order.size());
    m_runStart.assign(1, 0);
    const auto& rows = m_symbolic.rows;
    for (int s = 0; s < m_symbolic.count(); ++s) {
        const int p = m_parent[s];
        if (p >= 0) {
            for (int i = m_symbolic.rowStart[p]; i < m_symbolic.rowStart[p + 1]; ++i)
                place[rows[i]] = i - m_symbolic.rowStart[p];
            const int begin = m_symbolic.rowStart[s] + m_symbolic.columnsOf(s);
            for (int i = begin; i < m_symbolic.rowStart[s + 1]; ++i) {
                const int to = place[rows[i]];
                const bool goesOn = i > begin && m_runs.back().to + m_runs.back().length == to;
                if (goesOn)
                    ++m_runs.back().length;
                else
                    m_runs.push_back({i - begin, to, 1});
            }
        }
        m_runStart.push_back(static_cast<int>(m_runs.size()));
    }
}

/// Where every value of the matrix goes. Those above the diagonal (the diagonal blocks are full) are left
/// out.
template <class Real>
void SupernodalFactor<Real>::mapEntries(const std::vector<int>& columnStart, const std::vector<int>& row) {
    const int unknowns = static_cast<int>(m_symbolic.order.size());
    std::vector<int> step(unknowns), owner(unknowns), place(unknowns);
    for (int i = 0; i < unknowns; ++i) step[m_symbolic.order[i]] = i;
    for (int s = 0; s < m_symbolic.count(); ++s)
        std::fill(owner.begin() + m_symbolic.first[s], owner.begin() + m_symbolic.first[s + 1], s);
    struct Value {
        int source, row, column;
    };
    std::vector<std::vector<Value>> values(m_symbolic.count());
    for (int j = 0; j < unknowns; ++j)
        for (int i = columnStart[j]; i < columnStart[j + 1]; ++i) {
            if (row[i] < j) continue;
            const int a = step[row[i]], b = step[j], column = std::min(a, b);
            values[owner[column]].push_back({i, std::max(a, b), column});
        }
    m_entryStart.assign(1, 0);
    for (int s = 0; s < m_symbolic.count(); ++s) {
        const int begin = m_symbolic.rowStart[s];
        for (int i = begin; i < m_symbolic.rowStart[s + 1]; ++i) place[m_symbolic.rows[i]] = i - begin;
        for (const auto& value : values[s])
            m_entries.push_back({value.source, static_cast<unsigned>(value.column - m_symbolic.first[s]) *
                                                       static_cast<unsigned>(leading(s)) +
                                                   static_cast<unsigned>(place[value.row])});
        m_entryStart.push_back(static_cast<int>(m_entries.size()));
    }
}

/// The child's update matrix into the parent's front: its pivot columns lie in the panel, the others in its
/// own update matrix, both with rows counted from the front's first. Block by block, so that one length of
/// runs serves many columns: most are short, and a mispredicted end costs more than their sums.
template <class Real>
void SupernodalFactor<Real>::extendAdd(int child, int parent) {
    const Real* const from = update(child);
    const auto leadingFrom = static_cast<std::size_t>(updateLeading(child));
    const auto leadingPanel = static_cast<std::size_t>(leading(parent)),
               leadingUpdate = static_cast<std::size_t>(updateLeading(parent));
    const int pivots = m_symbolic.columnsOf(parent);
    Real *const panelFront = panel(parent), *const updateFront = update(parent) - pivots;
    const auto column = [&](int c) {
        return c < pivots ? panelFront + c * leadingPanel : updateFront + (c - pivots) * leadingUpdate;
    };
    const Run *const begin = m_runs.data() + m_runStart[child], *const end =
                                                                    m_runs.data() + m_runStart[child + 1];
    for (const Run* columns = begin; columns != end; ++columns) {
        const Real* const source = from + columns->from * leadingFrom;
        for (int c = 0; c < columns->length; ++c)
            add(column(columns->to + c) + columns->to + c, source + c * leadingFrom + columns->from + c,
                columns->length - c);
        for (const Run* rows = columns + 1; rows != end; ++rows)
            for (int c = 0; c < columns->length; ++c)
                add(column(columns->to + c) + rows->to, source + c * leadingFrom + rows->from, rows->length);
    }
}

template <class Real>
bool SupernodalFactor<Real>::factorize(std::span<const double> values) {
    for (int s = 0; s < m_symbolic.count(); ++s) {
        Real* const front = panel(s);
        std::fill(front, m_panels + m_panelStart[s + 1], Real(0));
        for (int i = m_entryStart[s]; i < m_entryStart[s + 1]; ++i)
            front[m_entries[i].target] = static_cast<Real>(values[m_entries[i].source]);
        const int below = updateRows(s), leadingUpdate = updateLeading(s), columns = m_symbolic.columnsOf(s);
        std::fill_n(update(s), static_cast<std::size_t>(leadingUpdate) * below, Real(0));
        for (int child : m_children[s]) extendAdd(child, s);
        if (!dense::factorPanel(front, leading(s), columns, m_inverse.data() + m_symbolic.first[s]))
            return false;
        dense::subtractSquare(front + columns, leading(s), columns, update(s), leadingUpdate, below);
    }
    return true;
}

template <class Real>
void SupernodalFactor<Real>::forwardSolve() {
    for (int s = 0; s < m_symbolic.count(); ++s) {
        const int columns = m_symbolic.columnsOf(s), rows = m_symbolic.rowsOf(s), first = m_symbolic.first[s];
        const int* const index = m_symbolic.rows.data() + m_symbolic.rowStart[s];
        std::copy_n(m_x.begin() + first, columns, m_w.begin());
        std::fill(m_w.begin() + columns, m_w.begin() + leading(s), Real(0));
        dense::forward(panel(s), leading(s), columns, m_inverse.data() + first, m_w.data(),
                       m_x.data() + first);
        for (int i = columns; i < rows; ++i) m_x[index[i]] += m_w[i];
    }
}

template <class Real>
void SupernodalFactor<Real>::backwardSolve() {
    for (int s = m_symbolic.count() - 1; s >= 0; --s) {
        const int columns = m_symbolic.columnsOf(s), rows = m_symbolic.rowsOf(s), first = m_symbolic.first[s];
        const int* const index = m_symbolic.rows.data() + m_symbolic.rowStart[s];
        std::fill_n(m_w.begin(), columns, Real(0));
        for (int i = columns; i < rows; ++i) m_w[i] = m_x[index[i]];
        std::fill(m_w.begin() + rows, m_w.begin() + leading(s), Real(0));
        dense::backward(panel(s), leading(s), columns, m_inverse.data() + first, m_w.data(),
                        m_x.data() + first);
    }
}

// Scaled to 1, so that the residuals of the last iterations stay in the range of single precision.
template <class Real>
bool SupernodalFactor<Real>::solve(std::span<const double> b, std::span<double> x) {
    double size = 0;
    for (double value : b) size = std::max(size, std::abs(value));
    const double scale = size > 0 ? 1 / size : 1.0;
    const auto& order = m_symbolic.order;
    for (std::size_t i = 0; i < order.size(); ++i) m_x[i] = static_cast<Real>(scale * b[order[i]]);
    forwardSolve();
    backwardSolve();
    bool finite = std::isfinite(size);
    for (std::size_t i = 0; i < order.size(); ++i) {
        finite = finite && std::isfinite(m_x[i]);
        x[order[i]] = m_x[i] / scale;
    }
    return finite;
}

template class SupernodalFactor<float>;
template class SupernodalFactor<double>;

}  // namespace wend
