#include "core/solver/multigrid/local_forms.h"

#include <Eigen/LU>

#include "core/energy/smoothness.h"

namespace wend {

template <int Dim>
LocalForms<Dim>::LocalForms(std::shared_ptr<const AssemblyPlan<Dim>> plan,
                            std::shared_ptr<const SimplicialMesh<Dim>> rest, Material<Dim> material)
    : m_plan(std::move(plan)), m_rest(std::move(rest)), m_material(std::move(material)) {}

template <int Dim>
CellGeometry<Dim> LocalForms<Dim>::geometry(int c) const {
    auto geometry = cellGeometry<Dim>(*m_shape, m_plan->cells[c]);
    geometry.measure = std::abs(geometry.measure);
    return geometry;
}

/// B(t) = R B₀ Rᵀ with R the rotation of the cell's map from rest (docs/method.md, (7)).
template <int Dim>
Mat<Dim> LocalForms<Dim>::anisotropy(int c) const {
    if (m_material.anisotropy.empty()) return Mat<Dim>::Identity();
    const auto& cell = m_plan->cells[c];
    const Mat<Dim> R =
        polarRotation<Dim>(edgeMatrix<Dim>(*m_shape, cell) * edgeMatrix<Dim>(m_rest->points, cell).inverse());
    return R * m_material.anisotropy[c] * R.transpose();
}

template <int Dim>
typename LocalForms<Dim>::Form LocalForms<Dim>::cell(int c) const {
    Form form;
    const auto shape = geometry(c);
    form.count = Dim + 1;
    for (int k = 0; k <= Dim; ++k) {
        form.vertices[k] = m_plan->cells[c][k];
        form.columns[k] = strainColumns<Dim>(shape.gradients.col(k));
    }
    form.weight = 0.25 * shape.measure * stressMatrix<Dim>(weights(c), anisotropy(c));
    if (!m_massRegularization.empty())
        form.mass = m_massRegularization[c] * shape.measure / ((Dim + 1) * (Dim + 2));
    return form;
}

template <int Dim>
typename LocalForms<Dim>::Form LocalForms<Dim>::facet(int f) const {
    const auto& facet = m_plan->facets[f];
    const auto [i, j] = facet.cells;
    const bool stress = m_material.smoothing.kind == SmoothingKind::Paper;
    Form form;
    const auto add = [&](int c, double sign) {
        const auto shape = geometry(c);
        StressMatrix<Dim> D;
        if (stress) D = stressMatrix<Dim>(weights(c), anisotropy(c));
        for (int k = 0; k <= Dim; ++k) {
            StrainColumns<Dim> G = sign * strainColumns<Dim>(shape.gradients.col(k));
            if (stress) G = (D * G).eval();
            const int v = m_plan->cells[c][k];
            int at = 0;
            while (at < form.count && form.vertices[at] != v) ++at;
            if (at < form.count) {
                form.columns[at] += G;
                continue;
            }
            form.vertices[at] = v;
            form.columns[at] = G;
            ++form.count;
        }
    };
    add(i, -1);
    add(j, 1);
    const double weight = smoothnessWeight<Dim>(m_material.smoothing, *m_shape, facet.vertices,
                                                m_plan->cells[i], m_plan->cells[j]);
    if (stress) {
        form.weight = weight * StressMatrix<Dim>::Identity();
        return form;
    }
    const Mat<Dim> B = m_material.anisotropy.empty() ? Mat<Dim>(Mat<Dim>::Identity())
                                                     : Mat<Dim>(0.5 * (anisotropy(i) + anisotropy(j)));
    form.weight = 0.25 * weight * stressMatrix<Dim>(jumpWeights(weights(i), weights(j)), B);
    return form;
}

template class LocalForms<2>;
template class LocalForms<3>;

}  // namespace wend
