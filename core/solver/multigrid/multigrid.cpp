#include "core/solver/multigrid/multigrid.h"

#include <limits>

namespace wend {

template <int Dim>
void Multigrid<Dim>::analyze(const AssemblyPlan<Dim>& plan, Aggregates aggregates) {
    m_aggregates = std::move(aggregates);
    m_matrix.analyze(plan, m_system, static_cast<int>(m_aggregates.of.size()), m_backEnd.workers());
}

/// x ↦ a + B (x − centre), B scaled to the extent of the shape, at every unknown vertex.
template <int Dim>
auto Multigrid<Dim>::linearMotions(const Points<Dim>& shape) const
    -> std::vector<typename Prolongation<Dim, kModes>::Motions> {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    Vec<Dim> centre;
    for (int k = 0; k < Dim; ++k) {
        const bool none = shape.cols() == 0;
        const double high = m_links.largest(none ? -kInfinity : shape.row(k).maxCoeff()),
                     low = -m_links.largest(none ? -kInfinity : -shape.row(k).minCoeff());
        centre[k] = 0.5 * (high + low);
    }
    std::vector<typename Prolongation<Dim, kModes>::Motions> motions;
    motions.reserve(m_aggregates.of.size());
    for (std::size_t i = 0; i < m_aggregates.of.size(); ++i) {
        const Vec<Dim> p = shape.col(m_system.unknowns()[i]) - centre;
        auto& B = motions.emplace_back();
        B.template leftCols<Dim>().setIdentity();
        for (int a = 0; a < Dim; ++a) B.template middleCols<Dim>(Dim * (a + 1)) = p[a] * Mat<Dim>::Identity();
        if (m_system.held().empty()) continue;
        for (int k = 0; k < Dim; ++k)
            if (m_system.held()[i] >> k & 1U) B.row(k).setZero();
    }
    return motions;
}

template <int Dim>
BuildStatus Multigrid<Dim>::build(const Points<Dim>& shape) {
    const bool made = m_matrix.build(m_backEnd);
    if (!m_links.decide(made)) return BuildStatus::Stopped;
    CoarseShare<kModes> share;
    const auto status = m_finest.build(m_matrix.blocks(), m_aggregates, linearMotions(shape), m_system.held(),
                                       m_links, m_backEnd.workers(), share);
    return status == BuildStatus::Done ? m_coarse.build(std::move(share)) : status;
}

template <int Dim>
bool Multigrid<Dim>::apply(std::span<const double> right, std::span<double> result) {
    const auto columns = static_cast<Eigen::Index>(m_system.unknowns().size());
    m_r = Eigen::Map<const Points<Dim>>(right.data(), Dim, columns);
    const auto solve = [this](const Points<kModes>& r, Points<kModes>& z) {
        m_coarseRight = r;
        return m_coarse.solve(m_coarseRight, z);
    };
    if (!m_finest.cycle(m_matrix.blocks(), m_r, m_z, solve, m_links, m_backEnd.workers())) return false;
    Eigen::Map<Points<Dim>>(result.data(), Dim, m_z.cols()) = m_z;
    return m_links.all(m_z.allFinite());
}

template class Multigrid<2>;
template class Multigrid<3>;

}  // namespace wend
