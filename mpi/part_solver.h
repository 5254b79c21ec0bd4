#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/solver/iterative_solver.h"
#include "core/solver/multigrid/coarse_levels.h"
#include "core/solver/multigrid/multigrid.h"
#include "mpi/division.h"
#include "mpi/packet.h"
#include "mpi/team.h"

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

/// A part of a system with what its process needs to work on it.
template <int Dim>
struct PartTask {
    Part<Dim> part;
    Points<Dim> rest;
    Material<Dim> material;
    std::vector<double> epsilon;  // of BackEnd::setMassRegularization()
    Aggregates aggregates;        // of its own unknowns
    // If the first coarse level is divided, too: the part of every aggregate of the whole, and the aggregates
    // of the next level among its own. Empty otherwise.
    std::vector<int> ownerOf;
    Aggregates groups;
    Graph gathered;  // of the first part: the aggregates of the first level that is not divided
    int threads = 1;

    void put(Packet& packet) const;
    static PartTask from(Packet& packet);
};

/// Solves for the part of one process. All processes call the same functions in the same order, the
/// constructor excepted. Vectors have a column for every vertex of the part.
template <int Dim>
class PartSolver {
  public:
    using Goal = typename IterativeSolver<Dim>::Goal;
    using Result = typename IterativeSolver<Dim>::Result;

    PartSolver(const Team& team, PartTask<Dim> task);

    int own() const { return m_own; }
    int vertices() const { return m_plan->vertexCount; }

    /// Does the same as BackEnd::setShape(); the returned cell is numbered as in the whole mesh.
    int setShape(Points<Dim> shape);
    /// Do the same as those of IterativeSolver. `stop`, `progress` and the goal's functions
    /// count in the first process.
    BuildStatus build(const std::stop_token& stop, const WorkerPool::Progress& progress);
    Result run(const Goal& goal, const Points<Dim>* load, Points<Dim>& v);
    /// Returns BackEnd::energy() of the whole mesh.
    double energy(const Points<Dim>& v);

  private:
    CoarseSolver<Multigrid<Dim>::kModes>& coarse(PartTask<Dim>& task);

    const Team& m_team;
    int m_own;
    std::vector<int> m_cells;      // their numbers in the whole mesh
    std::vector<int> m_followers;  // see Part
    std::vector<double> m_epsilon;
    TeamLinks m_links;
    std::shared_ptr<const SimplicialMesh<Dim>> m_rest;
    std::shared_ptr<const AssemblyPlan<Dim>> m_plan;
    ReducedSystem<Dim> m_system;
    std::unique_ptr<BackEnd<Dim>> m_backEnd;
    DividedCoarse<Multigrid<Dim>::kModes> m_gathered;
    std::optional<DividedLevel<Multigrid<Dim>::kModes>> m_coarse;
    Multigrid<Dim> m_multigrid;
    ConjugateGradients<Dim> m_iteration;
    Nodal<Dim> m_shape;
};

}  // namespace wend
