#pragma once

#include <functional>
#include <stop_token>
#include <vector>

#include "core/solver/iterative_solver.h"
#include "core/solver/multigrid/coarse_matrix.h"

namespace wend {

/// One level of multigrid: the smoother of its matrix, and the transfer to the next level. In a part of a
/// divided matrix all parts call the same functions.
template <int Size, int Modes>
class Level {
  public:
    using Motions = typename Prolongation<Size, Modes>::Motions;
    /// Computes z ≈ A⁻¹ r on the next level; returns false if the result is not finite.
    using CoarseSolve = std::function<bool(const Points<Modes>& r, Points<Modes>& z)>;

    /// Builds the level of K, whose rows have the motions of the near null space; `held` as in Chebyshev.
    /// Puts the contribution to the next level into `share`.
    BuildStatus build(const BlockRows<Size>& K, const Aggregates& aggregates,
                      const std::vector<Motions>& motions, const std::vector<unsigned>& held,
                      const PartLinks& links, WorkerPool& workers, CoarseShare<Modes>& share);
    /// Computes z ≈ K⁻¹ r, a column per row; r is overwritten. Returns false if the threads are stopped. It
    /// smooths before and after the coarse correction by the same polynomial, so that the whole is symmetric.
    bool cycle(const BlockRows<Size>& K, Points<Size>& r, Points<Size>& z, const CoarseSolve& solve,
               const PartLinks& links, WorkerPool& workers);

  private:
    Chebyshev<Size> m_smoother;
    Prolongation<Size, Modes> m_prolongation;
    Points<Size> m_step;
    Points<Modes> m_right, m_coarse;
};

}  // namespace wend
