#pragma once

#include <memory>
#include <span>
#include <vector>

#include "core/assembly/assembly_plan.h"
#include "core/assembly/corner_lists.h"
#include "core/assembly/rest_kernels.h"
#include "core/energy/cell_energy.h"
#include "core/energy/material.h"
#include "core/energy/rest_density.h"
#include "core/factor/worker_pool.h"

namespace wend {

/// Computes W(x) = Σ V₀ w(F) of a shape x, and its derivatives. This energy draws a shape back to its rest
/// (docs/method.md, (19)). Coordinates are in the frame where the rest shape has size 1. Sums run in the
/// plan's order and have the same bits for any number of threads. One thread uses it at a time.
template <int Dim>
class RestEnergy {
  public:
    RestEnergy(std::shared_ptr<const AssemblyPlan<Dim>> plan, const SimplicialMesh<Dim>& rest,
               const Material<Dim>& material);

    /// Returns V₀ of a cell.
    double measure(int cell) const { return m_measure[cell]; }
    /// Returns W of a shape (Dim × n); infinite if a cell is inverted. It is 0 at rest and after rigid
    /// motions. The sum runs in one thread.
    double energy(const Points<Dim>& shape) const;
    /// Computes ∇W (Dim × n). No cell may be inverted. The columns sum to 0 up to rounding, because W does
    /// not change with a translation.
    void gradient(const Points<Dim>& shape, Points<Dim>& gradient, WorkerPool& workers);

    /// Computes the Hessian at a shape, in which no cell may be inverted, for the next two functions. The
    /// negative eigenvalues of every cell's ∂²w/∂F² are multiplied by `negative`: 1 is the exact Hessian, 0
    /// makes it positive semidefinite.
    void linearize(const Points<Dim>& shape, double negative, WorkerPool& workers);
    /// Adds the Hessian to Dim × Dim blocks in the order of the plan's pattern (AssemblyPlan), which has to
    /// list its contributions.
    void addHessian(std::span<double> blocks, WorkerPool& workers);
    /// Computes Hv = H v with the Hessian of linearize(), without the matrix.
    void applyHessian(const Points<Dim>& v, Points<Dim>& Hv, WorkerPool& workers);
    /// Returns a t in [0, 1] such that no cell is flat or inverted at shape + s · step for 0 ≤ s < t, near
    /// the greatest one: the determinants are polynomials in s, bounded by their Bernstein coefficients.
    double unfoldedPart(const Points<Dim>& shape, const Points<Dim>& step) const;

  private:
    using CellHessian = CornerHessian<Dim>;
    void prepareCells();
    bool isIsotropic() const { return m_anisotropy.empty(); }
    rest::Cells<Dim> cells() const;
    Mat<Dim> mapOf(const Points<Dim>& shape, int cell) const;
    Mat<Dim> tangentMap(int cell) const;
    void gather(Points<Dim>& sum, WorkerPool& workers) const;
    void setForces(int cell, const Mat<Dim>& forces);
    void linearizeCell(int cell, double negative, const Mat<Dim>& F);
    Mat<Dim> hessianBlock(int left, int right) const;
    Mat<Dim> anisotropy(int c) const {
        return isIsotropic() ? Mat<Dim>(Mat<Dim>::Identity()) : m_anisotropy[c];
    }

    std::shared_ptr<const AssemblyPlan<Dim>> m_plan;
    // Per cell.
    std::vector<EnergyWeights> m_weights;
    std::vector<Mat<Dim>> m_anisotropy;  // B₀, or empty: all identity
    std::vector<Mat<Dim>> m_restInverse;
    std::vector<double> m_measure;  // V₀
    // For B₀ = I: see rest::Cells.
    std::vector<int> m_vertices;
    std::vector<double> m_q, m_r, m_measures, m_hats, m_tangent;

    CornerLists<Dim> m_corners;  // with the forces V₀ ∂w/∂F h_k of gradient() and those of products
    bool m_isTangent = false;    // linearize() has filled m_tangent, not m_hessian
    std::vector<CellHessian> m_hessian;  // of the corners 1 … of the cell; corner 0 has minus their sum
};

}  // namespace wend
