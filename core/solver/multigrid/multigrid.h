#pragma once

#include <memory>
#include <span>
#include <stop_token>
#include <string>

#include "core/assembly/back_end.h"
#include "core/solver/iterative_solver.h"
#include "core/solver/multigrid/chebyshev.h"
#include "core/solver/multigrid/galerkin.h"
#include "core/solver/reduced_system.h"

namespace wend {

/// A preconditioner for K = Zᵀ A Z that never has K: a symmetric V-cycle whose finest level is smoothed with
/// matrix-free products, and whose coarse matrix, 20 to 30 times smaller, is left to algebraic multigrid.
/// Memory and work grow with the number of vertices. The same bits for any number of threads.
template <int Dim>
class Multigrid {
  public:
    using Status = typename IterativeSolver<Dim>::Status;

    /// The back end and the system outlive it. Throws InputError where the module for coarse levels is
    /// missing.
    Multigrid(BackEnd<Dim>& backEnd, const ReducedSystem<Dim>& system, LocalForms<Dim> forms);

    /// What follows from cells and constraints alone; epsilon as in BackEnd::setMassRegularization().
    void analyze(std::shared_ptr<const AssemblyPlan<Dim>> plan, std::vector<double> epsilon);
    /// All levels at a shape, which is the back end's.
    Status build(std::shared_ptr<const Points<Dim>> shape, const std::stop_token& stop);
    /// z ≈ K⁻¹ r, K at the back end's present shape; false if that is not finite.
    bool apply(std::span<const double> r, std::span<double> z);

    const BlockMatrix& coarseMatrix() const { return m_galerkin.matrix(); }

  private:
    void product(const Points<Dim>& x, Points<Dim>& Kx);

    BackEnd<Dim>& m_backEnd;
    const ReducedSystem<Dim>& m_system;
    LocalForms<Dim> m_forms;
    CoarseSpace<Dim> m_space;
    Galerkin<Dim> m_galerkin;
    Chebyshev<Dim> m_smoother;
    std::unique_ptr<AlgebraicHierarchy> m_hierarchy;
    Points<Dim> m_lifted, m_Alifted, m_r, m_z, m_step, m_Kstep;
    std::vector<double> m_right, m_coarse;
};

}  // namespace wend
