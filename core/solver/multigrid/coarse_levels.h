#pragma once

#include <vector>

#include "core/factor/factor.h"
#include "core/solver/multigrid/level.h"

namespace wend {

/// Solves with the coarse matrix of multigrid, nearly: all levels but the finest.
template <int Modes>
class CoarseSolver {
  public:
    virtual ~CoarseSolver() = default;

    /// Takes the share of the part that the finest level belongs to.
    virtual BuildStatus build(CoarseShare<Modes> share) = 0;
    /// z ≈ A⁻¹ r in the rows of the share; r is what they add to the right-hand side, and is spoilt. False if
    /// that is not finite.
    virtual bool solve(Points<Modes>& r, Points<Modes>& z) = 0;
};

/// In this process, of a system that is not divided: down to a matrix that is factored.
template <int Modes>
class CoarseLevels final : public CoarseSolver<Modes> {
  public:
    static constexpr int kFactored = 2000;  // unknowns; of more a coarser level is made

    /// The threads outlive it.
    explicit CoarseLevels(WorkerPool& workers) : m_workers(workers) {}

    /// The groups of all levels, from which aggregates are next to each other.
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
