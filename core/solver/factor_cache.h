#pragma once

#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include "core/assembly/back_end.h"
#include "core/factor/factor.h"
#include "core/solver/conjugate_gradients.h"
#include "core/solver/iterative_solver.h"
#include "core/solver/reduced_system.h"
#include "core/solver/refactor_policy.h"
#include "core/solver/velocity_solver.h"

namespace wend {

/// The factor that serves one solve after another: at which shape it was made, how well it has served, and
/// when a new one pays. What of this decides the bits of the next solves is FactorMemory; the factor itself
/// may have been made elsewhere since (for a single solve, or from another memory) and is made again then.
/// In the place of a factor there may be the levels of multigrid, which serve in the same way.
template <int Dim>
class FactorCache {
  public:
    /// These outlive it.
    FactorCache(BackEnd<Dim>& backEnd, ReducedSystem<Dim>& system, SolverStatistics& statistics)
        : m_backEnd(backEnd), m_system(system), m_statistics(statistics) {}

    /// From now on multigrid takes the factor's place. It outlives this, too.
    void useMultigrid(IterativeSolver<Dim>& multigrid) { m_multigrid = &multigrid; }

    /// Of another system: nothing is kept, and it is to be analyzed. The plan outlives it, too.
    void reset(const AssemblyPlan<Dim>& plan);
    /// The symbolic analysis of the system, unless it is there. False if it was stopped.
    bool analyze(const std::stop_token& stop);

    FactorMemory<Dim> remember() const;
    void recall(const FactorMemory<Dim>& memory);
    RefactorPolicy& policy() { return m_policy; }
    /// Of long factorizations: see Factor::factorize().
    void setProgress(FieldProgress progress) { m_progress = std::move(progress); }
    std::span<double> values() { return m_factor.values(); }

    /// A new factor, at the back end's shape: one that lasts, in the poorest precision that serves here, or
    /// one for a single solve, in double precision, both by CHOLMOD where that is quicker, or (`exact`) by
    /// CHOLMOD. One that lasts is made ahead of the shape where it is known with which velocities that moves:
    /// it serves on both sides.
    enum class Use { Lasting, Once, OnceExact };
    SolveOutcome make(Use use, const std::stop_token& stop, const Points<Dim>* velocity = nullptr);
    /// The factor of the memory is at hand, made again if another was made since. False if there is none, if
    /// a new one pays, or if it cannot be had, as with other constraints.
    bool restore(const std::stop_token& stop);
    /// Single precision is not enough here: from now on factors are double. False if they are already.
    bool improve();

    /// How far the back end's shape is from the factor's.
    double lag() { return m_memory.lag = m_backEnd.stages().distance(m_memory.shape); }
    /// Whether the factor was made at another shape than the back end's at that time.
    bool isAhead() const { return m_memory.ahead > 0; }
    const Nodal<Dim>& shape() const { return m_memory.shape; }
    /// To which shape the factor is to be turned for the back end's.
    const Nodal<Dim>& turnedShape();
    bool isSingle() const { return m_memory.kind == FactorKind::Single; }
    /// x ≈ K⁻¹ b with the factor at hand; false if that is not finite.
    bool solve(std::span<const double> b, std::span<double> x) {
        return m_factor.solve(b, x, m_backEnd.workers());
    }

    /// By how much an iteration reduces the error: the first one at that lag, and any one at best.
    double expectedContraction(double lag) const;
    double minContraction() const;
    /// What an evaluation has shown of that.
    void learn(double lag, const typename ConjugateGradients<Dim>::Result& result);

  private:
    Nodal<Dim> goAhead(const Points<Dim>& velocity);
    SolveOutcome factorize(const Nodal<Dim>& shape, FactorKind kind, const std::stop_token& stop);
    std::function<void(double)> progressOf(FieldWork work) const;
    Factor::Status makeFactor(FactorKind kind, const std::stop_token& stop);
    Factor::Status makeLevels(const Nodal<Dim>& shape, const std::stop_token& stop);
    /// Multigrid is in double precision, and no more exact than a factor in single.
    FactorKind kind() const { return m_multigrid ? FactorKind::Double : m_factor.kind(); }
    bool isRough() const { return m_multigrid || isSingle(); }

    BackEnd<Dim>& m_backEnd;
    ReducedSystem<Dim>& m_system;  // another only while a factor is made again
    SolverStatistics& m_statistics;
    const AssemblyPlan<Dim>* m_plan = nullptr;
    bool m_analyzed = false;
    FieldProgress m_progress;
    Factor m_factor;
    IterativeSolver<Dim>* m_multigrid = nullptr;
    Nodal<Dim> m_shape;          // where the factor at hand was made; null: it has served
    FactorMemory<Dim> m_memory;  // its counts are the policy's
    RefactorPolicy m_policy;
    std::vector<double> m_blocks;  // of A
};

extern template class FactorCache<2>;
extern template class FactorCache<3>;

}  // namespace wend
