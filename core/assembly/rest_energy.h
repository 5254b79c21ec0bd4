#pragma once

#include <memory>
#include <vector>

#include "core/assembly/assembly_plan.h"
#include "core/energy/cell_energy.h"
#include "core/energy/material.h"
#include "core/factor/worker_pool.h"

namespace wend {

/// W(x) = Σ V₀ w(F) of a shape, and its gradient: what a shape remembers of its rest (docs/method.md, (19)).
/// In the frame where the rest shape has size 1. Sums run in the plan's order: the same bits for any number
/// of threads. One thread uses it at a time.
template <int Dim>
class RestEnergy {
  public:
    RestEnergy(std::shared_ptr<const AssemblyPlan<Dim>> plan, const SimplicialMesh<Dim>& rest,
               const Material<Dim>& material);

    /// Infinite if a cell is inverted.
    double energy(const Points<Dim>& shape) const;
    /// One column per vertex. No cell may be inverted.
    void gradient(const Points<Dim>& shape, Points<Dim>& gradient, WorkerPool& workers);

  private:
    Mat<Dim> mapOf(const Points<Dim>& shape, int cell) const;
    Mat<Dim> anisotropy(int c) const {
        return m_anisotropy.empty() ? Mat<Dim>(Mat<Dim>::Identity()) : m_anisotropy[c];
    }

    std::shared_ptr<const AssemblyPlan<Dim>> m_plan;
    // Per cell.
    std::vector<EnergyWeights> m_weights;
    std::vector<Mat<Dim>> m_anisotropy;  // B₀, or empty: all identity
    std::vector<Mat<Dim>> m_restInverse;
    std::vector<double> m_measure;  // V₀
    std::vector<Mat<Dim>> m_force;  // V₀ ∂w/∂F E₀⁻ᵀ: columns are the forces on the corners 1 …, of gradient()
};

}  // namespace wend
