#pragma once

#include <span>
#include <stop_token>
#include <vector>

#include "core/solver/multigrid/coarse_levels.h"
#include "core/solver/multigrid/reduced_matrix.h"

namespace wend {

/// A preconditioner for K = Zᵀ A Z: a symmetric V-cycle of smoothed aggregation on K in single precision,
/// down to a matrix that is factorized. Coarse fields are linear in the place within each aggregate, because
/// rigid motions alone are too rough where the smoothness, which is of fourth order, outweighs the energy.
/// Memory and work grow with the number of vertices. Results have the same bits for any number of threads. In
/// a part of a divided system all parts call the same functions.
template <int Dim>
class Multigrid {
  public:
    static constexpr int kModes = Dim * (Dim + 1);

    /// The arguments must outlive this object.
    Multigrid(BackEnd<Dim>& backEnd, const ReducedSystem<Dim>& system, const PartLinks& links,
              CoarseSolver<kModes>& coarse)
        : m_backEnd(backEnd), m_system(system), m_links(links), m_coarse(coarse) {}

    /// Prepares everything that follows from cells and constraints alone. The plan must outlive this object.
    /// `aggregates` are of the first unknowns, which are the part's own: none of these has unknowns in other
    /// parts.
    void analyze(const AssemblyPlan<Dim>& plan, Aggregates aggregates);
    /// Builds all levels at a shape, which is the back end's.
    BuildStatus build(const Points<Dim>& shape);
    /// Computes z ≈ K⁻¹ r in the part's own unknowns, with K at the shape of the levels; returns false if the
    /// result is not finite. The operator is symmetric and positive definite, as conjugate gradients need it,
    /// and takes time linear in the unknowns. r and z have Dim numbers per unknown.
    bool apply(std::span<const double> r, std::span<double> z);

  private:
    std::vector<typename Prolongation<Dim, kModes>::Motions> linearMotions(const Points<Dim>& shape) const;

    BackEnd<Dim>& m_backEnd;
    const ReducedSystem<Dim>& m_system;
    const PartLinks& m_links;
    CoarseSolver<kModes>& m_coarse;
    Aggregates m_aggregates;
    ReducedMatrix<Dim> m_matrix;
    Level<Dim, kModes> m_finest;
    Points<Dim> m_r, m_z;
    Points<kModes> m_coarseRight;
};

}  // namespace wend
