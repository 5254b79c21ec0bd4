#include "core/solver/multigrid/multigrid.h"

namespace wend {
namespace {

constexpr int kDegree = 3;  // of the smoother, before and after the coarse correction

template <int Dim>
typename CoarseSpace<Dim>::Unknowns unknownsOf(const ReducedSystem<Dim>& system, int vertexCount) {
    typename CoarseSpace<Dim>::Unknowns result;
    result.vertices = system.unknowns();
    result.isUnknown.assign(vertexCount, 0);
    for (int v : result.vertices) result.isUnknown[v] = 1;
    if (!system.held().empty()) result.held.assign(vertexCount, 0);
    for (std::size_t i = 0; i < system.held().size(); ++i) result.held[result.vertices[i]] = system.held()[i];
    for (const auto& pivot : system.elimination().pivots) {
        typename CoarseSpace<Dim>::Row row;
        for (const auto& [other, weight] : pivot.free)
            if (result.isUnknown[other]) row.emplace_back(other, -weight);
        if (!row.empty()) result.dependent.emplace_back(pivot.vertex, std::move(row));
    }
    return result;
}

}  // namespace

template <int Dim>
Multigrid<Dim>::Multigrid(BackEnd<Dim>& backEnd, const ReducedSystem<Dim>& system, LocalForms<Dim> forms)
    : m_backEnd(backEnd),
      m_system(system),
      m_forms(std::move(forms)),
      m_hierarchy(makeAlgebraicHierarchy()) {}

template <int Dim>
void Multigrid<Dim>::analyze(std::shared_ptr<const AssemblyPlan<Dim>> plan, std::vector<double> epsilon) {
    m_forms.setMassRegularization(std::move(epsilon));
    auto unknowns = unknownsOf<Dim>(m_system, plan->vertexCount);
    m_space.analyze(std::move(plan), std::move(unknowns));
    m_galerkin.analyze(m_space);
}

template <int Dim>
void Multigrid<Dim>::product(const Points<Dim>& x, Points<Dim>& Kx) {
    m_lifted.setZero(Dim, m_space.plan().vertexCount);
    m_system.expand(x, m_lifted);
    m_backEnd.apply(m_lifted, m_Alifted);
    m_system.restrict(m_Alifted, Kx);
}

template <int Dim>
typename Multigrid<Dim>::Status Multigrid<Dim>::build(std::shared_ptr<const Points<Dim>> shape,
                                                      const std::stop_token& stop) {
    WorkerPool& workers = m_backEnd.workers();
    m_forms.setShape(std::move(shape));
    m_space.build(m_forms, workers);
    if (stop.stop_requested() || !m_galerkin.build(m_space, m_forms, workers, stop)) return Status::Stopped;
    std::vector<Mat<Dim>> diagonal;
    diagonal.reserve(m_system.unknowns().size());
    for (int v : m_system.unknowns()) diagonal.push_back(m_galerkin.diagonal()[v]);
    const bool definite = m_smoother.prepare(
        std::move(diagonal), m_system.held(), [&](const Points<Dim>& x, Points<Dim>& Kx) { product(x, Kx); },
        workers);
    if (!definite) return Status::NotPositiveDefinite;
    if (stop.stop_requested()) return Status::Stopped;
    const auto problem =
        m_hierarchy->build(m_galerkin.matrix(), m_space.rigidMotions(), CoarseSpace<Dim>::kModes);
    return problem.empty() ? Status::Done : Status::NotPositiveDefinite;
}

/// Smoothed before and after the coarse correction by the same polynomial, so that all of it is symmetric.
template <int Dim>
bool Multigrid<Dim>::apply(std::span<const double> right, std::span<double> result) {
    WorkerPool& workers = m_backEnd.workers();
    const auto columns = static_cast<Eigen::Index>(m_system.unknowns().size());
    const auto multiply = [&](const Points<Dim>& x, Points<Dim>& Kx) { product(x, Kx); };
    m_r = Eigen::Map<const Points<Dim>>(right.data(), Dim, columns);
    m_z.setZero(Dim, columns);
    m_smoother.smooth(kDegree, true, multiply, m_r, m_z, workers);
    m_space.restrict(m_r, m_right, workers);
    m_coarse.resize(m_right.size());
    if (!m_hierarchy->apply(m_right, m_coarse)) return false;
    m_step.setZero(Dim, columns);
    m_space.prolong(m_coarse, m_step, workers);
    m_z += m_step;
    product(m_step, m_Kstep);
    m_r -= m_Kstep;
    m_smoother.smooth(kDegree, false, multiply, m_r, m_z, workers);
    Eigen::Map<Points<Dim>>(result.data(), Dim, columns) = m_z;
    return m_z.allFinite();
}

template class Multigrid<2>;
template class Multigrid<3>;

}  // namespace wend
