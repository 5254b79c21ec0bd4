#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <span>
#include <stop_token>
#include <vector>

#include "core/base/large_array.h"
#include "core/factor/dense_kernels.h"
#include "core/factor/elimination_tree.h"
#include "core/factor/supernodes.h"
#include "core/factor/worker_pool.h"

namespace wend {

/// Gets the fraction of a factorization that is done, in [0, 1], at most once for each hundredth and from any
/// thread.
using FactorProgress = std::function<void(double)>;

/// Computes a supernodal multifrontal Cholesky factorization. In double precision it solves, with small
/// fronts, in half of CHOLMOD's time; single precision takes half of that again (half the bytes, twice the
/// lanes) and serves as a preconditioner, which solves a matrix of condition number κ to about κ · 1e-7. It
/// reports a pivot that is lost to rounding; the caller then needs a more accurate factor. The threads
/// compute the subtrees of the elimination tree at the same time, then share the large fronts of its
/// separator; their number does not change a bit of the result.
template <class Real>
class SupernodalFactor {
  public:
    SupernodalFactor() = default;
    /// Takes a symbolic factor, and the pattern of the lower triangle by columns as for Cholesky::analyze().
    SupernodalFactor(Supernodes symbolic, std::span<const int> columnStart, std::span<const int> row);

    /// Factorizes the values of the pattern. Returns false if a pivot is not positive, or if it was stopped;
    /// a stop is noticed between fronts, and between the pieces of large ones.
    bool factorize(std::span<const double> values, WorkerPool& workers, std::stop_token stop = {},
                   const FactorProgress& progress = {});
    /// Solves x ≈ K⁻¹ b; returns false if the result is not finite. A factorization must have succeeded. b
    /// and x have one number per unknown and may be the same array. The work is proportional to the entries
    /// of the factor, and the result has the same bits for any number of threads.
    bool solve(std::span<const double> b, std::span<double> x, WorkerPool& workers);

    /// Return the bytes of the factor with the update matrices of that many threads, and how many of them the
    /// next factorization will allocate.
    double bytes(int threads) const;
    double bytesToTake(int threads) const;

  private:
    struct Run {  // rows of an update matrix that are consecutive in the parent's front, too
        int from, to, length;
    };
    /// The place of a value of the matrix in the panel of its supernode.
    struct Entry {
        int source;       // in the values
        unsigned target;  // in the panel
    };
    void placePanels();
    void placeUpdates();
    std::size_t placeUpdates(std::span<const int> group);
    double stackBytes(int threads) const;
    void reserve(int threads);
    void placeWorkspaces();
    void mapUpdates();
    void mapEntries(std::span<const int> columnStart, std::span<const int> row);

    int leading(int s) const;
    int updateRows(int s) const { return m_symbolic.rowsOf(s) - m_symbolic.columnsOf(s); }
    int updateLeading(int s) const;
    Real* panel(int s) { return m_panels.data() + m_panelStart[s]; }
    Real* inverse(int s) { return m_inverse.data() + m_symbolic.first[s]; }
    /// Returns the update matrix of a supernode; `stacks` are those of the thread that does its subtree, or
    /// of the separator.
    Real* update(int s, Real* stacks) {
        return (m_isSubtreeRoot[s] ? m_updates.data() : stacks) + m_updateStart[s];
    }

    /// Counts the work on a front, or on a part of it, as done. The work of a front is its number of columns
    /// times the square of its number of rows.
    class Meter {
      public:
        void start(const FactorProgress& progress, double work);
        void add(double work);

      private:
        FactorProgress m_progress;
        double m_work = 1;
        std::atomic<double> m_done = 0;
        std::atomic<int> m_reported = 0;  // hundredths
    };
    double work(int s) const;
    bool factorSubtrees(std::span<const double> values, WorkerPool& workers);
    bool factorFront(int s, std::span<const double> values, Real* stacks);
    bool factorFront(int s, std::span<const double> values, Real* stacks, WorkerPool& workers);
    void assemblePanel(int s, std::span<const double> values);
    bool factorPanel(int s, WorkerPool& workers);
    void makeUpdate(int s, int begin, int end, Real* stacks);
    void extendAdd(int child, int parent, int begin, int end, Real* stacks);

    void forwardSolve(WorkerPool& workers);
    void forwardSubtree(int subtree);
    void forwardFront(int s, Real* w, WorkerPool* workers);
    void backwardSolve(WorkerPool& workers);
    void backwardFront(int s, Real* w, WorkerPool* workers);

    Supernodes m_symbolic;
    EliminationTree m_tree;
    const dense::Kernels<Real>* m_kernels = nullptr;             // those of the factorization
    std::stop_token m_stop;                                      // of the running factorization
    std::unique_ptr<Meter> m_meter = std::make_unique<Meter>();  // of the running factorization
    std::vector<std::size_t> m_panelStart, m_updateStart;
    std::vector<int> m_runStart;  // per supernode: into m_runs, for its update matrix
    std::vector<Run> m_runs;
    std::vector<int> m_entryStart;  // per supernode: into m_entries
    std::vector<Entry> m_entries;

    LargeArray<Real> m_panels;
    std::vector<Real> m_inverse;

    // Update matrices: those of the subtrees' roots, then the stacks of the separator and of every thread.
    std::vector<char> m_isSubtreeRoot;  // per supernode: the root of a subtree
    LargeArray<Real> m_updates;
    std::size_t m_separatorStacks = 0, m_threadStacks = 0,
                m_stackSize = 0;  // where they begin; of one thread
    int m_threads = 0;            // that there are stacks for

    bool m_isPaired = false;  // the unknowns: see comeInPairs()
    // Of a solve: x, and behind it for every subtree what it adds to the rows above it.
    std::vector<Real> m_x;
    std::vector<int> m_target;                // per row of a supernode: its place in m_x
    std::vector<std::size_t> m_contribution;  // per subtree: where its sums begin
    std::vector<Real> m_w;  // a front's part of x: one for every subtree and one for the separator
    std::vector<std::size_t> m_workspace;  // per subtree, and for the separator
};

extern template class SupernodalFactor<float>;
extern template class SupernodalFactor<double>;

}  // namespace wend
