#include "core/assembly/rest_energy.h"

#include <Eigen/LU>

#include "core/energy/rest_density.h"

namespace wend {
template <int Dim>
RestEnergy<Dim>::RestEnergy(std::shared_ptr<const AssemblyPlan<Dim>> plan, const SimplicialMesh<Dim>& rest,
                            const Material<Dim>& material)
    : m_plan(std::move(plan)), m_anisotropy(material.anisotropy), m_force(rest.cells.size()) {
    for (int c = 0; c < rest.cellCount(); ++c) {
        m_weights.push_back(EnergyWeights::of(material.phi[c]));
        m_restInverse.push_back(edgeMatrix<Dim>(rest.points, rest.cells[c]).inverse());
        m_measure.push_back(std::abs(cellMeasure<Dim>(rest.points, rest.cells[c])));
    }
}

template <int Dim>
Mat<Dim> RestEnergy<Dim>::mapOf(const Points<Dim>& shape, int cell) const {
    return edgeMatrix<Dim>(shape, m_plan->cells[cell]) * m_restInverse[cell];
}

template <int Dim>
double RestEnergy<Dim>::energy(const Points<Dim>& shape) const {
    double sum = 0;
    for (int c = 0; c < m_plan->cellCount(); ++c)
        sum += m_measure[c] * restDensity<Dim>(m_weights[c], anisotropy(c), mapOf(shape, c));
    return sum;
}

/// ∂W/∂x_k = V₀ ∂w/∂F g_k with the hat gradients g_k at rest, the columns of E₀⁻ᵀ; all corners' sum is zero.
template <int Dim>
void RestEnergy<Dim>::gradient(const Points<Dim>& shape, Points<Dim>& gradient, WorkerPool& workers) {
    workers.forPieces(m_plan->cellCount(), kPlanGrain, [&](int begin, int end) {
        for (int c = begin; c < end; ++c)
            m_force[c] = m_measure[c] * restStress<Dim>(m_weights[c], anisotropy(c), mapOf(shape, c)) *
                         m_restInverse[c].transpose();
    });
    gradient.resize(Dim, m_plan->vertexCount);
    workers.forPieces(m_plan->vertexCount, kPlanGrain, [&](int begin, int end) {
        for (int p = begin; p < end; ++p) {
            Vec<Dim> total = Vec<Dim>::Zero();
            for (int i = m_plan->cornerStart[p]; i < m_plan->cornerStart[p + 1]; ++i) {
                const int cell = m_plan->corners[i] / (Dim + 1), k = m_plan->corners[i] % (Dim + 1);
                if (k > 0)
                    total += m_force[cell].col(k - 1);
                else
                    total -= m_force[cell].rowwise().sum();
            }
            gradient.col(p) = total;
        }
    });
}

template class RestEnergy<2>;
template class RestEnergy<3>;

}  // namespace wend
