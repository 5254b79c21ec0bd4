#pragma once

#include <memory>
#include <vector>

#include "core/factor/worker_pool.h"
#include "core/solver/multigrid/local_forms.h"

namespace wend {

/// The coarse space of smoothed aggregation (Vaněk, Mandel, Brezina 1996) for velocity fields. Vertices are
/// grouped into aggregates of a vertex and its neighbours; a coarse field is a rigid motion of each, d (d +
/// 1) / 2 numbers, made smooth by a step of Jacobi's method on E_φ. The groups follow from the cells alone,
/// once per set of constraints; the motions from the shape.
template <int Dim>
class CoarseSpace {
  public:
    static constexpr int kModes = Dim * (Dim + 1) / 2;
    using Block = Eigen::Matrix<float, Dim, kModes>;  // a vertex's velocity from a coarse motion
    using Exact = Eigen::Matrix<double, Dim, kModes>;
    using Square = Eigen::Matrix<double, kModes, kModes>;

    /// One row of Z per vertex, as ReducedSystem has it: the unknown vertices that it depends on.
    using Row = std::vector<std::pair<int, double>>;
    struct Unknowns {
        std::vector<int> vertices;                   // of the unknowns
        std::vector<char> isUnknown;                 // per vertex
        std::vector<unsigned> held;                  // per vertex: bit k: coordinate k is 0; or empty
        std::vector<std::pair<int, Row>> dependent;  // vertices that follow from others
    };

    void analyze(std::shared_ptr<const AssemblyPlan<Dim>> plan, Unknowns unknowns);
    /// The motions at the shape of the forms.
    void build(const LocalForms<Dim>& forms, WorkerPool& workers);

    int aggregates() const { return m_count; }
    const Unknowns& unknowns() const { return m_unknowns; }
    const AssemblyPlan<Dim>& plan() const { return *m_plan; }
    /// Of a vertex: its aggregates, ascending, and their blocks.
    int begin(int vertex) const { return m_start[vertex]; }
    int end(int vertex) const { return m_start[vertex + 1]; }
    int aggregate(int entry) const { return m_aggregate[entry]; }
    const Block& block(int entry) const { return m_blocks[entry]; }
    /// Coarse motions that an aggregate of too few vertices does not have: bit k.
    unsigned missing(int aggregate) const { return m_missing[aggregate]; }

    /// Pᵀ r and z += P c; r, z one column per unknown, c one per aggregate.
    void restrict(const Points<Dim>& r, std::vector<double>& coarse, WorkerPool& workers) const;
    void prolong(const std::vector<double>& coarse, Points<Dim>& z, WorkerPool& workers) const;
    /// Rigid motions of the whole as coarse vectors, kModes of them one after the other.
    std::vector<double> rigidMotions() const;

  private:
    void aggregate();
    void listEntries();
    void makeMotions(const Points<Dim>& shape);
    void smooth(const LocalForms<Dim>& forms, int vertex);
    void follow();
    /// Calls visit for every other vertex of the cells of a vertex; some more than once.
    template <typename Visit>
    void forNeighbours(int vertex, Visit&& visit) const;

    std::shared_ptr<const AssemblyPlan<Dim>> m_plan;
    Unknowns m_unknowns;
    int m_count = 0;
    std::vector<int> m_of;  // per vertex: its own aggregate, or −1
    std::vector<int> m_members, m_memberStart;
    std::vector<int> m_start, m_aggregate;                  // per vertex: entries
    std::vector<Block> m_blocks;                            // per entry
    std::vector<int> m_usersStart, m_users, m_userEntries;  // per aggregate: unknowns, and their entries
    std::vector<Exact> m_motions;    // per vertex: those of its own aggregate, orthonormal there
    std::vector<Square> m_triangle;  // per aggregate: rigid motions in terms of those
    std::vector<Vec<Dim>> m_centre;  // per aggregate
    std::vector<double> m_radius;
    std::vector<unsigned> m_missing;
};

}  // namespace wend
