#pragma once

#include <span>
#include <stop_token>
#include <vector>

#include "core/factor/factor.h"
#include "core/solver/iterative_solver.h"
#include "core/solver/multigrid/coarse_matrix.h"
#include "core/solver/multigrid/reduced_matrix.h"

namespace wend {

/// One level: its matrix, the smoother, and the way to the next one.
template <int Size, int Modes>
struct Level {
    Aggregates aggregates;
    BlockRows<Size> matrix;
    Chebyshev<Size> smoother;
    Prolongation<Size, Modes> prolongation;
    Points<Size> r, z, step;
};

/// A preconditioner for K = Zᵀ A Z: a symmetric V-cycle of smoothed aggregation on K in single precision,
/// down to a matrix that is factored. Coarse fields are linear in the place within each aggregate: rigid
/// motions alone are too rough where the smoothness, which is of fourth order, outweighs the energy. Memory
/// and work grow with the number of vertices. The same bits for any number of threads.
template <int Dim>
class Multigrid {
  public:
    static constexpr int kModes = Dim * (Dim + 1);
    using Status = typename IterativeSolver<Dim>::Status;

    /// They outlive it.
    Multigrid(BackEnd<Dim>& backEnd, const ReducedSystem<Dim>& system)
        : m_backEnd(backEnd), m_system(system) {}

    /// What follows from cells and constraints alone. The plan outlives it.
    void analyze(const AssemblyPlan<Dim>& plan);
    /// All levels at a shape, which is the back end's.
    Status build(const Points<Dim>& shape, const std::stop_token& stop);
    /// z ≈ K⁻¹ r, K at the shape of the levels; false if that is not finite.
    bool apply(std::span<const double> r, std::span<double> z);

  private:
    using Coarse = Level<kModes, kModes>;
    std::vector<typename Prolongation<Dim, kModes>::Motions> linearMotions(const Points<Dim>& shape) const;
    template <int Size>
    Status buildNext(Level<Size, kModes>& level, const BlockRows<Size>& K,
                     std::vector<typename Prolongation<Size, kModes>::Motions> motions, std::size_t next,
                     const std::stop_token& stop);
    Status factorize(const BlockRows<kModes>& A, const std::stop_token& stop);
    template <int Size>
    bool cycle(Level<Size, kModes>& level, const BlockRows<Size>& K, std::size_t next);
    bool solveCoarsest(const Points<kModes>& r, Points<kModes>& z);

    BackEnd<Dim>& m_backEnd;
    const ReducedSystem<Dim>& m_system;
    ReducedMatrix<Dim> m_matrix;
    Level<Dim, kModes> m_finest;  // its matrix is the one above
    std::vector<Coarse> m_coarse;
    std::vector<unsigned> m_noneHeld;
    PartLinks m_links;
    Factor m_factor;  // of the matrix after all levels
    Points<kModes> m_r, m_z;
};

}  // namespace wend
