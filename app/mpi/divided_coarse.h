#pragma once

#include <optional>
#include <vector>

#include "app/mpi/team.h"
#include "core/solver/multigrid/coarse_levels.h"

namespace wend {

/// The coarse levels of a divided system in the first process, which gathers the shares of all parts: the
/// same levels as without a division.
template <int Modes>
class DividedCoarse final : public CoarseSolver<Modes> {
  public:
    /// In the first process, the graph is that of the aggregates of the whole. References must outlive this
    /// object.
    DividedCoarse(const Team& team, Graph aggregates, WorkerPool& workers);

    BuildStatus build(CoarseShare<Modes> share) override;
    bool solve(Points<Modes>& r, Points<Modes>& z) override;

  private:
    BuildStatus gather(CoarseShare<Modes> share);
    bool solveWhole(const Points<Modes>& r, Points<Modes>& z);

    const Team& m_team;
    CoarseLevels<Modes> m_levels;          // in the first process
    std::vector<std::vector<int>> m_rows;  // there: of every share
    int m_size = 0;                        // there: rows of the whole
    Points<Modes> m_right, m_result, m_values;
};

}  // namespace wend
