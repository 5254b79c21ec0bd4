#pragma once

#include <functional>
#include <optional>
#include <stop_token>
#include <vector>

#include "core/assembly/rest_energy.h"
#include "core/factor/factor.h"
#include "core/solver/reduced_system.h"
#include "core/solver/refactor_policy.h"
#include "core/solver/velocity_solver.h"

namespace wend {

/// The proximal term weight · (x − x₀)ᵀ A (x − x₀).
template <int Dim>
struct ProximalTerm {
    double weight = 0;
    Points<Dim> origin;          // x₀
    std::vector<double> blocks;  // of A, in the order of the plan's pattern
    std::function<void(const Points<Dim>& v, Points<Dim>& Av)> apply;
};

/// Minimizes W by Newton's method, with or without a proximal term, among the shapes that the constraints
/// allow (docs/method.md, section 8). A step d solves Zᵀ H Z y = −Zᵀ g with the exact Hessian if that is
/// positive definite, else with one that has less of the cells' negative curvature; it ends before any cell
/// is flat, and is halved until W decreases by Armijo's condition.
template <int Dim>
class RestMinimizer {
  public:
    /// The references must outlive this object. `massRegularization` has an ε for every cell, or is empty.
    RestMinimizer(const AssemblyPlan<Dim>& plan, RestEnergy<Dim>& energy, ReducedSystem<Dim>& system,
                  const std::vector<double>& massRegularization, WorkerPool& workers,
                  SolverStatistics& statistics);

    /// Moves the shape, which satisfies the constraints and has no inverted cell, to a minimum.
    Descended minimize(Points<Dim>& shape, const Descent<Dim>& descent, const ProximalTerm<Dim>* proximal,
                       const std::stop_token& stop);
    /// Says whether a step is exact, with a factor of its own, or computed for a live drag: an earlier
    /// factor, in single precision, serves for conjugate gradients as long as that pays.
    enum class Pace { Exact, Even };
    /// Computes the first Newton step from a shape in which the constrained points are displaced by
    /// `prescribed`, which has one column per row and may have one per slider behind them.
    SolveOutcome predict(Pace pace, const Points<Dim>& shape, const Points<Dim>& prescribed,
                         const ProximalTerm<Dim>* proximal, const std::stop_token& stop, Points<Dim>& step);

  private:
    SolveOutcome factorize(FactorKind kind, const Points<Dim>& shape, const ProximalTerm<Dim>* proximal,
                           const std::stop_token& stop);
    bool reuse(const Points<Dim>& shape, const ProximalTerm<Dim>* proximal, Points<Dim>& step);
    bool iterate(const ProximalTerm<Dim>* proximal, Points<Dim>& step);
    SolveOutcome solve(const ProximalTerm<Dim>* proximal, Points<Dim>& step);
    void product(const Points<Dim>& v, const ProximalTerm<Dim>* proximal, Points<Dim>& reduced);
    SolveOutcome factorizeAs(double negative, FactorKind kind, const Points<Dim>& shape,
                             const ProximalTerm<Dim>* proximal, const std::stop_token& stop);
    double value(const Points<Dim>& shape, const ProximalTerm<Dim>* proximal) const;
    double slope(const Points<Dim>& shape, const ProximalTerm<Dim>* proximal);
    bool nudge(Points<Dim>& shape);
    double lineSearch(Points<Dim>& shape, const Points<Dim>& step, double descent,
                      const ProximalTerm<Dim>* proximal, const Descent<Dim>& how) const;

    const AssemblyPlan<Dim>& m_plan;
    RestEnergy<Dim>& m_energy;
    ReducedSystem<Dim>& m_system;
    WorkerPool& m_workers;
    SolverStatistics& m_statistics;
    std::vector<double> m_mass;  // per vertex, that keeps free parts in place
    Factor m_factor;
    bool m_isExact = false;   // the Hessian of the factor
    bool m_isMade = false;    // the factor
    std::size_t m_level = 0;  // of the last factor: how much of the negative curvature it has
    int m_untilExact = 0;     // steps before the exact one is tried again
    std::vector<double> m_blocks;
    Points<Dim> m_gradient, m_reduced;
    RefactorPolicy m_policy;    // of predict()
    double m_contraction = 0;   // of the error, by the first iteration: the last one measured
    Points<Dim> m_r, m_z, m_p;  // of iterate(), per unknown, and the rest per vertex
    Points<Dim> m_lifted, m_product;
};

extern template class RestMinimizer<2>;
extern template class RestMinimizer<3>;

}  // namespace wend
