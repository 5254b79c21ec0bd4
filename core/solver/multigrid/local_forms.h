#pragma once

#include <memory>
#include <vector>

#include "core/assembly/assembly_plan.h"
#include "core/energy/cell_energy.h"
#include "core/energy/material.h"

namespace wend {

/// The energy E = E_φ + E_S at a shape as a sum of small squares, of which a coarse matrix is made without
/// the fine one: Σ ε_kᵀ M_k ε_k with ε_k = Σ_v G_kv v the strain of a cell (4 vertices, M = ¼ V D), or the
/// jump of strain or stress over a facet (5 vertices, M = ¼ weight D_f or weight I; docs/method.md, (10) to
/// (12)). Nothing is kept per cell: everything is computed at the call.
template <int Dim>
class LocalForms {
  public:
    static constexpr int kMost = Dim + 2;  // vertices
    struct Form {
        int count = 0;
        std::array<int, kMost> vertices;
        std::array<StrainColumns<Dim>, kMost> columns;  // G
        StressMatrix<Dim> weight;                       // M
        double mass = 0;                                // of (15): this times |Σ_p v_p|² + Σ_p |v_p|²
    };

    LocalForms(std::shared_ptr<const AssemblyPlan<Dim>> plan, std::shared_ptr<const SimplicialMesh<Dim>> rest,
               Material<Dim> material);

    void setShape(std::shared_ptr<const Points<Dim>> shape) { m_shape = std::move(shape); }
    const Points<Dim>& shape() const { return *m_shape; }
    /// ε of every cell, or empty: none.
    void setMassRegularization(std::vector<double> epsilon) { m_massRegularization = std::move(epsilon); }

    int cells() const { return m_plan->cellCount(); }
    int facets() const { return static_cast<int>(m_plan->facets.size()); }
    Form cell(int c) const;
    Form facet(int f) const;

  private:
    CellGeometry<Dim> geometry(int c) const;
    Mat<Dim> anisotropy(int c) const;
    EnergyWeights weights(int c) const {
        return EnergyWeights::of(m_material.phi[static_cast<std::size_t>(c)]);
    }

    std::shared_ptr<const AssemblyPlan<Dim>> m_plan;
    std::shared_ptr<const SimplicialMesh<Dim>> m_rest;
    Material<Dim> m_material;
    std::vector<double> m_massRegularization;
    std::shared_ptr<const Points<Dim>> m_shape;
};

}  // namespace wend
