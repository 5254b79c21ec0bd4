#include "core/factor/supernodal_factor.h"

#include <algorithm>
#include <atomic>
#include <numeric>

#include "core/factor/dense_kernels.h"

namespace wend {
namespace {

// A front with less work is left to one thread: the hand-over takes some microseconds.
constexpr double kSharedWork = 2e6;
constexpr int kPanelColumns = 64, kUpdateColumns = 64;  // of a piece

/// Computes to += from.
template <class Real>
inline void add(Real* to, const Real* from, int count) {
    int i = 0;
    for (; i + 4 <= count; i += 4)
        for (int k = 0; k < 4; ++k) to[i + k] += from[i + k];
    for (; i < count; ++i) to[i] += from[i];
}

}  // namespace

template <class Real>
SupernodalFactor<Real>::SupernodalFactor(Supernodes symbolic, std::span<const int> columnStart,
                                         std::span<const int> row)
    : m_symbolic(std::move(symbolic)), m_tree(makeEliminationTree(m_symbolic)) {
    placePanels();
    placeUpdates();
    placeWorkspaces();
    mapUpdates();
    mapEntries(columnStart, row);
}

template <class Real>
int SupernodalFactor<Real>::leading(int s) const {
    return dense::padded<Real>(m_symbolic.rowsOf(s));
}

template <class Real>
int SupernodalFactor<Real>::updateLeading(int s) const {
    return dense::padded<Real>(updateRows(s));
}

/// Places the panels one after another, with a cache line between them into which the kernels may read.
template <class Real>
void SupernodalFactor<Real>::placePanels() {
    m_panelStart.assign(1, 0);
    for (int s = 0; s < m_symbolic.count(); ++s)
        m_panelStart.push_back(m_panelStart.back() + dense::kPad<Real> +
                               static_cast<std::size_t>(leading(s)) * m_symbolic.columnsOf(s));
    m_inverse.resize(m_symbolic.order.size());
}

/// Places the update matrices: first those of the subtrees' roots, which outlive their subtree, then the
/// stacks of the separator and of the threads.
template <class Real>
void SupernodalFactor<Real>::placeUpdates() {
    m_updateStart.assign(m_symbolic.count(), 0);
    m_isSubtreeRoot.assign(m_symbolic.count(), 0);
    for (const auto& subtree : m_tree.subtrees) {
        const int root = subtree.root();
        m_isSubtreeRoot[root] = 1;
        m_updateStart[root] = m_separatorStacks;
        m_separatorStacks += static_cast<std::size_t>(updateLeading(root)) * updateRows(root);
    }
    std::vector<int> group;
    for (const auto& subtree : m_tree.subtrees) {
        group.resize(subtree.root() - subtree.begin);
        std::iota(group.begin(), group.end(), subtree.begin);
        m_stackSize = std::max(m_stackSize, placeUpdates(group));
    }
    m_threadStacks = m_separatorStacks + placeUpdates(m_tree.separator);
}

/// Places update matrices on two stacks of their group, by the parity of their depth, where they wait for
/// their parent: a front can then be built on one stack while its children are on top of the other. Returns
/// the size of both. In postorder the children of a front are the top of their stack when it is built, so its
/// own update matrix goes onto the other one, and that of its first child is where the children's stack ends
/// afterwards. Two stacks thus replace a copy of every update matrix or a list of free blocks.
template <class Real>
std::size_t SupernodalFactor<Real>::placeUpdates(std::span<const int> group) {
    std::vector<int> stack(m_symbolic.count());
    std::size_t top[2] = {0, 0}, most[2] = {0, 0};
    for (auto s = group.rbegin(); s != group.rend(); ++s)
        if (const int parent = m_tree.parent[*s]; parent >= 0) stack[*s] = 1 - stack[parent];
    const auto inGroup = [&](int child) { return std::binary_search(group.begin(), group.end(), child); };
    for (const int s : group) {
        const int own = stack[s];
        m_updateStart[s] = top[own];
        top[own] += static_cast<std::size_t>(updateLeading(s)) * updateRows(s);
        most[own] = std::max(most[own], top[own]);
        const auto& children = m_tree.children[s];
        const auto first = std::find_if(children.begin(), children.end(), inGroup);
        if (first != children.end()) top[1 - own] = m_updateStart[*first];
    }
    for (const int s : group)
        if (stack[s] == 1) m_updateStart[s] += most[0];
    return most[0] + most[1];
}

template <class Real>
double SupernodalFactor<Real>::stackBytes(int threads) const {
    return sizeof(Real) * (static_cast<double>(m_threadStacks) + threads * static_cast<double>(m_stackSize));
}

template <class Real>
double SupernodalFactor<Real>::bytes(int threads) const {
    return sizeof(Real) * static_cast<double>(m_panelStart.back()) + stackBytes(std::max(threads, m_threads));
}

template <class Real>
double SupernodalFactor<Real>::bytesToTake(int threads) const {
    const double panels =
        m_panels.data() == nullptr ? sizeof(Real) * static_cast<double>(m_panelStart.back()) : 0;
    if (threads <= m_threads) return panels;
    return panels + stackBytes(threads) - (m_threads > 0 ? stackBytes(m_threads) : 0);
}

template <class Real>
void SupernodalFactor<Real>::reserve(int threads) {
    if (m_panels.data() == nullptr) m_panels = LargeArray<Real>(m_panelStart.back() + dense::kPad<Real>);
    if (threads <= m_threads) return;
    m_threads = threads;
    m_updates = {};  // never two at a time
    m_updates = LargeArray<Real>(m_threadStacks + static_cast<std::size_t>(threads) * m_stackSize +
                                 dense::kPad<Real>);
}

/// Finds the runs of consecutive rows of every update matrix in the front of its parent, for extendAdd().
/// Both lists of rows ascend, and the update's rows are all in the parent's front. Runs rather than single
/// rows make the sums of extendAdd() contiguous.
template <class Real>
void SupernodalFactor<Real>::mapUpdates() {
    std::vector<int> place(m_symbolic.order.size());
    m_runStart.assign(1, 0);
    const auto& rows = m_symbolic.rows;
    for (int s = 0; s < m_symbolic.count(); ++s) {
        const int p = m_tree.parent[s];
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

/// Maps every value of the matrix to its place. Values above the diagonal (the diagonal blocks are full) are
/// left out.
template <class Real>
void SupernodalFactor<Real>::mapEntries(std::span<const int> columnStart, std::span<const int> row) {
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

/// Adds the child's update matrix to the columns [begin, end) of the parent's front: pivot columns are in the
/// panel, the others in the parent's own update matrix, both with rows counted from the front's first. It
/// works block by block, so that one length of runs serves many columns: most are short, and a mispredicted
/// end costs more than their sums.
template <class Real>
void SupernodalFactor<Real>::extendAdd(int child, int parent, int begin, int end, Real* stacks) {
    const Real* const from = update(child, stacks);
    const auto leadingFrom = static_cast<std::size_t>(updateLeading(child));
    const int pivots = m_symbolic.columnsOf(parent);
    const bool inPanel = begin < pivots;
    Real* const front = inPanel ? panel(parent) : update(parent, stacks) - pivots;
    const auto leadingFront = static_cast<std::size_t>(inPanel ? leading(parent) : updateLeading(parent));
    const auto column = [&](int c) { return front + (inPanel ? c : c - pivots) * leadingFront; };
    const Run *const first = m_runs.data() + m_runStart[child], *const last =
                                                                    m_runs.data() + m_runStart[child + 1];
    const auto before = [&](const Run& run) { return run.to + run.length <= begin; };
    for (const Run* columns = std::partition_point(first, last, before); columns != last; ++columns) {
        if (columns->to >= end) break;
        const int cBegin = std::max(0, begin - columns->to),
                  cEnd = std::min(columns->length, end - columns->to);
        const Real* const source = from + columns->from * leadingFrom;
        for (int c = cBegin; c < cEnd; ++c)
            add(column(columns->to + c) + columns->to + c, source + c * leadingFrom + columns->from + c,
                columns->length - c);
        for (const Run* rows = columns + 1; rows != last; ++rows)
            for (int c = cBegin; c < cEnd; ++c)
                add(column(columns->to + c) + rows->to, source + c * leadingFrom + rows->from, rows->length);
    }
}

/// Fills the panel of a front with zeros, and adds the values of the matrix at their places.
template <class Real>
void SupernodalFactor<Real>::assemblePanel(int s, std::span<const double> values) {
    Real* const front = panel(s);
    const int columns = m_symbolic.columnsOf(s);
    const auto rows = static_cast<std::size_t>(leading(s));
    for (int c = 0; c < columns; ++c)  // from the group of the diagonal on
        std::fill(front + c * rows + c / dense::kPad<Real> * dense::kPad<Real>, front + (c + 1) * rows,
                  Real(0));
    for (int i = m_entryStart[s]; i < m_entryStart[s + 1]; ++i)
        front[m_entries[i].target] = static_cast<Real>(values[m_entries[i].source]);
}

/// Computes the columns [begin, end) of the update matrix U = −L21 L21ᵀ + Σ U_child of a panel that is
/// factorized: what the front leaves for its ancestors to add.
template <class Real>
void SupernodalFactor<Real>::makeUpdate(int s, int begin, int end, Real* stacks) {
    const int columns = m_symbolic.columnsOf(s);
    m_kernels->squareNegated(panel(s) + columns, leading(s), columns, update(s, stacks), updateLeading(s),
                             begin, end);
    for (int child : m_tree.children[s]) extendAdd(child, s, columns + begin, columns + end, stacks);
}

/// Factorizes a front in one thread, by the multifrontal method (Duff and Reid 1983): sums up the matrix and
/// the children's updates in the pivot columns, factorizes these, computes the update for the parent, and
/// turns the panel into the form that solves use. The update needs L21 as it is, so prepareSolves() comes
/// last.
template <class Real>
bool SupernodalFactor<Real>::factorFront(int s, std::span<const double> values, Real* stacks) {
    const int columns = m_symbolic.columnsOf(s);
    assemblePanel(s, values);
    for (int child : m_tree.children[s]) extendAdd(child, s, 0, columns, stacks);
    if (!m_kernels->factorColumns(panel(s), leading(s), 0, columns, leading(s), inverse(s))) return false;
    makeUpdate(s, 0, updateRows(s), stacks);
    m_kernels->prepareSolves(panel(s), leading(s), columns, 0, leading(s), inverse(s));
    m_meter->add(work(s));
    return true;
}

/// Factorizes in blocks of columns: one thread does a block's triangle, all of them the rows below. Since the
/// triangle of a block needs only the block's own rows of earlier columns, the threads wait for each other
/// once per block of kPanelColumns columns.
template <class Real>
bool SupernodalFactor<Real>::factorPanel(int s, WorkerPool& workers) {
    const int columns = m_symbolic.columnsOf(s), rows = leading(s);
    Real *const front = panel(s), *const inverses = inverse(s);
    const double part =
        work(s) / columns / (updateRows(s) > 0 ? 2 : 1);  // the update matrix is the other half
    for (int from = 0; from < columns; from += kPanelColumns) {
        const int to = std::min(columns, from + kPanelColumns), below = dense::padded<Real>(to);
        if (m_stop.stop_requested()) return false;
        if (!m_kernels->factorColumns(front, rows, from, to, below, inverses)) return false;
        workers.forPieces(rows - below, 16 * dense::kPad<Real>, [&](int begin, int end) {
            if (m_stop.stop_requested()) return;
            m_kernels->continueColumns(front, rows, from, to, below + begin, below + end, inverses);
        });
        m_meter->add(part * (to - from));
    }
    return !m_stop.stop_requested();
}

/// Factorizes a front with all threads if it is large enough to pay for that, else in this thread alone.
template <class Real>
bool SupernodalFactor<Real>::factorFront(int s, std::span<const double> values, Real* stacks,
                                         WorkerPool& workers) {
    const int columns = m_symbolic.columnsOf(s), below = updateRows(s);
    const double rows = m_symbolic.rowsOf(s);
    if (columns * rows * rows < kSharedWork) return factorFront(s, values, stacks);
    assemblePanel(s, values);
    workers.forPieces(columns, kPanelColumns, [&](int begin, int end) {
        for (int child : m_tree.children[s]) extendAdd(child, s, begin, end, stacks);
    });
    if (!factorPanel(s, workers)) return false;
    workers.forPieces(below, kUpdateColumns, [&](int begin, int end) {
        if (m_stop.stop_requested()) return;
        makeUpdate(s, begin, end, stacks);
        m_meter->add(work(s) * (end - begin) / below / 2);
    });
    const int top = dense::padded<Real>(columns);
    workers.forPieces(leading(s) - top, 16 * dense::kPad<Real>, [&](int begin, int end) {
        m_kernels->prepareSolves(panel(s), leading(s), columns, top + begin, top + end, inverse(s));
    });
    m_kernels->prepareSolves(panel(s), leading(s), columns, 0, top, inverse(s));
    return !m_stop.stop_requested();
}

/// Every thread takes one subtree after another, with stacks of its own. A subtree needs nothing but its own
/// fronts, and its arithmetic is the same in every thread. Within it the postorder puts children before their
/// parents.
template <class Real>
bool SupernodalFactor<Real>::factorSubtrees(std::span<const double> values, WorkerPool& workers) {
    std::atomic<std::size_t> next = 0;
    std::atomic<bool> goesOn = true;
    workers.forPieces(m_threads, 1, [&](int thread, int) {
        Real* const stacks = m_updates.data() + m_threadStacks + thread * m_stackSize;
        for (std::size_t i = next++; i < m_tree.subtrees.size(); i = next++) {
            const auto& subtree = m_tree.subtrees[i];
            for (int s = subtree.begin; s < subtree.end && goesOn; ++s)
                if (m_stop.stop_requested() || !factorFront(s, values, stacks)) goesOn = false;
        }
    });
    return goesOn;
}

template <class Real>
double SupernodalFactor<Real>::work(int s) const {
    const double rows = m_symbolic.rowsOf(s);
    return m_symbolic.columnsOf(s) * rows * rows;
}

template <class Real>
void SupernodalFactor<Real>::Meter::start(const FactorProgress& progress, double work) {
    m_progress = progress;
    m_work = work;
    m_done = 0;
    m_reported = 0;
}

template <class Real>
void SupernodalFactor<Real>::Meter::add(double work) {
    if (!m_progress) return;
    const double done = std::min(1.0, (m_done.fetch_add(work) + work) / m_work);
    const int hundredths = static_cast<int>(100 * done);
    int reported = m_reported;
    if (hundredths > reported && m_reported.compare_exchange_strong(reported, hundredths)) m_progress(done);
}

/// Factorizes the subtrees concurrently, one thread for each, and then the fronts of the separator with all
/// threads.
template <class Real>
bool SupernodalFactor<Real>::factorize(std::span<const double> values, WorkerPool& workers,
                                       std::stop_token stop, const FactorProgress& progress) {
    m_stop = std::move(stop);
    m_kernels = &dense::kernels<Real>();
    double all = 0;
    for (int s = 0; s < m_symbolic.count(); ++s) all += work(s);
    m_meter->start(progress, all);
    reserve(workers.threads());
    return factorSubtrees(values, workers) &&
           std::all_of(m_tree.separator.begin(), m_tree.separator.end(), [&](int s) {
               return factorFront(s, values, m_updates.data() + m_separatorStacks, workers);
           });
}

template class SupernodalFactor<float>;
template class SupernodalFactor<double>;

}  // namespace wend
