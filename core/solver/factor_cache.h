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

/// Keeps the factor that serves one solve after another: at which shape it was made, how well it has served,
/// and when a new one pays. FactorMemory is the part of this that determines the bits of the next solves; the
/// factor itself may have been made elsewhere since (for a single solve, or from another memory) and is made
/// again in that case. The levels of multigrid may take the place of a factor; they serve in the same manner.
template <int Dim>
class FactorCache {
  public:
    /// The arguments must outlive this object.
    FactorCache(BackEnd<Dim>& backEnd, ReducedSystem<Dim>& system, SolverStatistics& statistics)
        : m_backEnd(backEnd), m_system(system), m_statistics(statistics) {}

    /// Replaces the factor by multigrid from now on; it must outlive this object, too.
    void useMultigrid(IterativeSolver<Dim>& multigrid) { m_multigrid = &multigrid; }

    /// Starts with another system: nothing is kept, and the system must be analyzed. The plan must outlive
    /// this object, too.
    void reset(const AssemblyPlan<Dim>& plan);
    /// Does the symbolic analysis of the system unless it is done. Returns false if it was stopped.
    bool analyze(const std::stop_token& stop);

    /// Return and restore what determines the next solves.
    FactorMemory<Dim> remember() const;
    void recall(const FactorMemory<Dim>& memory);
    RefactorPolicy& policy() { return m_policy; }
    /// Sets the receiver of progress in long factorizations: see Factor::factorize().
    void setProgress(FieldProgress progress) { m_progress = std::move(progress); }
    std::span<double> values() { return m_factor.values(); }

    /// Says what a new factor is for: for many solves, in the least precise kind that works here; for a
    /// single solve, in double precision (both by CHOLMOD where that is faster); or for a single solve by
    /// CHOLMOD in any case.
    enum class Use { Lasting, Once, OnceExact };
    /// Makes a new factor at the back end's shape. A lasting one is made ahead of that shape if the shape's
    /// velocities are known, so that it serves on both sides of it.
    SolveOutcome make(Use use, const std::stop_token& stop, const Points<Dim>* velocity = nullptr);
    /// Makes the factor of the memory available, and computes it again if another was made since. Returns
    /// false if there is none, if a new one pays, or if it cannot be made, as with other constraints.
    bool restore(const std::stop_token& stop);
    /// Uses double precision from now on, because single is not enough here. Returns false if it is used
    /// already.
    bool improve();

    /// Returns how far the back end's shape is from the factor's.
    double lag() { return m_memory.lag = m_backEnd.stages().distance(m_memory.shape); }
    /// Returns whether the factor was made at a shape other than the back end's at that time.
    bool isAhead() const { return m_memory.ahead > 0; }
    const Nodal<Dim>& shape() const { return m_memory.shape; }
    /// Returns the shape to which the factor is turned for the back end's.
    const Nodal<Dim>& turnedShape();
    bool isSingle() const { return m_memory.kind == FactorKind::Single; }
    /// Computes x ≈ K⁻¹ b with the current factor; returns false if the result is not finite.
    bool solve(std::span<const double> b, std::span<double> x) {
        return m_factor.solve(b, x, m_backEnd.workers());
    }

    /// Return the factor by which an iteration reduces the error: the first one at that lag, and any one at
    /// best.
    double expectedContraction(double lag) const;
    double minContraction() const;
    /// Adjusts these expectations to the result of an evaluation.
    void learn(double lag, const typename ConjugateGradients<Dim>::Result& result);

  private:
    Nodal<Dim> goAhead(const Points<Dim>& velocity);
    SolveOutcome factorize(const Nodal<Dim>& shape, FactorKind kind, const std::stop_token& stop);
    std::function<void(double)> progressOf(FieldWork work) const;
    Factor::Status makeFactor(FactorKind kind, const std::stop_token& stop);
    Factor::Status makeLevels(const Nodal<Dim>& shape, const std::stop_token& stop);
    /// Returns the kind of the current factor. Multigrid is in double precision, but no more exact than a
    /// factor in single.
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
