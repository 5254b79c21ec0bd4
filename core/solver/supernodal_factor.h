#pragma once

#include <span>
#include <vector>

#include "core/solver/supernodes.h"

namespace wend {

/// A supernodal multifrontal Cholesky factorization. In double precision it solves, on small fronts, in half
/// of CHOLMOD's time; in single precision in half of that again (half the bytes, twice the lanes), as a
/// preconditioner: of a matrix of condition κ it solves to about κ · 1e-7. Where a pivot is lost to rounding
/// it says so; then a better factor must serve. One thread; the same input gives the same bits.
template <class Real>
class SupernodalFactor {
  public:
    SupernodalFactor() = default;
    /// Pattern of the lower triangle by columns, as for Cholesky::analyze.
    SupernodalFactor(Supernodes symbolic, const std::vector<int>& columnStart, const std::vector<int>& row);

    /// From the values of the pattern; false if a pivot is not positive.
    bool factorize(std::span<const double> values);
    /// x ≈ K⁻¹ b; false if that is not finite.
    bool solve(std::span<const double> b, std::span<double> x);

  private:
    struct Run {  // rows of an update matrix that are consecutive in the parent's front, too
        int from, to, length;
    };
    struct Entry {
        int source;       // in the values
        unsigned target;  // in the panel
    };
    void layOut();
    void placeUpdates();
    void mapUpdates();
    void mapEntries(const std::vector<int>& columnStart, const std::vector<int>& row);
    int leading(int s) const;
    int updateRows(int s) const { return m_symbolic.rowsOf(s) - m_symbolic.columnsOf(s); }
    int updateLeading(int s) const;
    Real* panel(int s) { return m_panels + m_panelStart[s]; }
    Real* update(int s) { return m_updates[m_depth[s] % 2] + m_updateStart[s]; }
    void extendAdd(int child, int parent);
    void forwardSolve();
    void backwardSolve();

    Supernodes m_symbolic;
    std::vector<int> m_parent, m_depth;        // per supernode; parent −1: a root
    std::vector<std::vector<int>> m_children;  // in elimination order
    std::vector<std::size_t> m_panelStart, m_updateStart;
    std::vector<int> m_runStart;  // per supernode: into m_runs, for its update matrix
    std::vector<Run> m_runs;
    std::vector<int> m_entryStart;  // per supernode: into m_entries
    std::vector<Entry> m_entries;

    // Update matrices wait for their parent on two stacks, by the parity of their depth: a front can then be
    // built on one stack while its children lie on top of the other.
    std::vector<Real> m_storage, m_updateStorage[2], m_inverse, m_w, m_x;
    Real *m_panels = nullptr, *m_updates[2] = {};
};

extern template class SupernodalFactor<float>;
extern template class SupernodalFactor<double>;

}  // namespace wend
