#pragma once

#include <vector>

#include "core/factor/factor.h"
#include "core/solver/multigrid/level.h"

namespace wend {

/// Solves approximately with the coarse matrix of multigrid, by all levels but the finest.
template <int Modes>
class CoarseSolver {
  public:
    virtual ~CoarseSolver() = default;

    /// Takes the share of the part that the finest level belongs to, and builds the levels.
    virtual BuildStatus build(CoarseShare<Modes> share) = 0;
    /// Computes z ≈ A⁻¹ r in the rows of the share. r is what they add to the right-hand side, and is
    /// overwritten. Returns false if the result is not finite.
    virtual bool solve(Points<Modes>& r, Points<Modes>& z) = 0;
};

/// Solves in this process, for a system that is not divided, down to a matrix that is factorized.
template <int Modes>
class CoarseLevels final : public CoarseSolver<Modes> {
  public:
    static constexpr int kFactored = 2000;  // unknowns; of more a coarser level is made

    /// The threads must outlive this object.
    explicit CoarseLevels(WorkerPool& workers) : m_workers(workers) {}

    /// Finds the groups of all levels; `aggregates` is the graph of the finest level's groups.
    void analyze(Graph aggregates);
    BuildStatus build(CoarseShare<Modes> share) override;
    bool solve(Points<Modes>& r, Points<Modes>& z) override { return cycle(0, r, z); }

  private:
    BuildStatus factorize(const BlockRows<Modes>& A);
    void fill(const BlockRows<Modes>& A, double shift);
    bool cycle(std::size_t level, Points<Modes>& r, Points<Modes>& z);

    struct Stage {
        Aggregates aggregates;
        BlockRows<Modes> matrix;
        Level<Modes, Modes> level;
        Points<Modes> r;
    };
    WorkerPool& m_workers;
    PartLinks m_links;
    std::vector<Stage> m_stages;
    Factor m_factor;  // of the matrix after all of these
};

}  // namespace wend
