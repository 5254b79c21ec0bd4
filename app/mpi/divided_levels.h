#pragma once

#include <optional>
#include <vector>

#include "app/mpi/team.h"
#include "core/solver/multigrid/coarse_levels.h"

namespace wend {

/// The first coarse level of a divided system, divided in turn: each process has the rows of the aggregates
/// that are its own.
template <int Modes>
class DividedLevel final : public CoarseSolver<Modes> {
  public:
    /// `ownerOf` has the process of every aggregate of the whole; `groups` are the next level's aggregates of
    /// its own ones, ascending. References must outlive this object.
    DividedLevel(const Team& team, std::vector<int> ownerOf, Aggregates groups, CoarseSolver<Modes>& next,
                 WorkerPool& workers);

    BuildStatus build(CoarseShare<Modes> share) override;
    bool solve(Points<Modes>& r, Points<Modes>& z) override;

  private:
    struct Row {
        std::vector<int> columns;  // numbers in the whole, ascending
        std::vector<Eigen::Matrix<float, Modes, Modes>> blocks;
    };
    std::vector<Row> exchangeRows(const CoarseShare<Modes>& share) const;
    void listUsers(const CoarseShare<Modes>& share);
    std::vector<Neighbour> number(const std::vector<Row>& rows);
    BlockRows<Modes> matrixOf(std::vector<Row> rows, const CoarseShare<Modes>& share) const;
    int ownPlace(int number) const;

    const Team& m_team;
    std::vector<int> m_ownerOf, m_own;
    Aggregates m_groups;
    CoarseSolver<Modes>& m_next;
    WorkerPool& m_workers;
    std::vector<int> m_copied;                             // numbers of the copies, process by process
    std::vector<std::vector<int>> m_touched, m_touchedBy;  // per process: rows of the share; own rows
    std::optional<TeamLinks> m_links;
    BlockRows<Modes> m_matrix;
    Level<Modes, Modes> m_level;
    Points<Modes> m_r, m_z, m_nextRight;
};

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
