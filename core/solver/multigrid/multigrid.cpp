#include "core/solver/multigrid/multigrid.h"

namespace wend {
namespace {

constexpr int kDegree = 3;       // of the smoother, before and after the coarse correction
constexpr int kFactored = 2000;  // unknowns; of more a coarser level is made

}  // namespace

template <int Dim>
void Multigrid<Dim>::analyze(const AssemblyPlan<Dim>& plan) {
    m_matrix.analyze(plan, m_system, static_cast<int>(m_system.unknowns().size()), m_backEnd.workers());
    Graph graph = graphOf<Dim>(plan, m_system);
    m_finest.aggregates = aggregatesOf(graph);
    m_coarse.clear();
    for (const Aggregates* last = &m_finest.aggregates; last->count * kModes > kFactored;) {
        graph = quotient(graph, *last);
        auto aggregates = aggregatesOf(graph);
        if (aggregates.count == graph.size()) break;
        m_coarse.emplace_back().aggregates = std::move(aggregates);
        last = &m_coarse.back().aggregates;
    }
}

/// x ↦ a + B (x − centre), B scaled to the extent of the shape, at every unknown vertex.
template <int Dim>
auto Multigrid<Dim>::linearMotions(const Points<Dim>& shape) const
    -> std::vector<typename Prolongation<Dim, kModes>::Motions> {
    const Vec<Dim> centre = 0.5 * (shape.rowwise().minCoeff() + shape.rowwise().maxCoeff());
    std::vector<typename Prolongation<Dim, kModes>::Motions> motions;
    motions.reserve(m_system.unknowns().size());
    for (std::size_t i = 0; i < m_system.unknowns().size(); ++i) {
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
template <int Size>
auto Multigrid<Dim>::buildNext(Level<Size, kModes>& level, const BlockRows<Size>& K,
                               std::vector<typename Prolongation<Size, kModes>::Motions> motions,
                               std::size_t next, const std::stop_token& stop) -> Status {
    WorkerPool& workers = m_backEnd.workers();
    const auto& held = Size == Dim ? m_system.held() : m_noneHeld;
    if (!level.smoother.prepare(K, held, m_links, workers)) return Status::NotPositiveDefinite;
    if (stop.stop_requested()) return Status::Stopped;
    auto coarseMotions = level.prolongation.build(level.aggregates, motions, K, level.smoother, workers);
    motions = {};
    if (stop.stop_requested()) return Status::Stopped;
    auto A = coarseMatrix<Size, kModes>(K, level.prolongation, workers, stop);
    if (stop.stop_requested()) return Status::Stopped;
    if (next == m_coarse.size()) return factorize(A, stop);
    Coarse& coarse = m_coarse[next];
    coarse.matrix = std::move(A);
    return buildNext<kModes>(coarse, coarse.matrix, std::move(coarseMotions), next + 1, stop);
}

template <int Dim>
auto Multigrid<Dim>::factorize(const BlockRows<kModes>& A, const std::stop_token& stop) -> Status {
    std::vector<int> start{0}, row;
    for (int j = 0; j < A.rows(); ++j)
        for (int k = 0; k < kModes; ++k) {
            for (int e = A.entryOf(j, j); e < A.begin(j + 1); ++e)
                for (int i = 0; i < kModes; ++i) row.push_back(A.column(e) * kModes + i);
            start.push_back(static_cast<int>(row.size()));
        }
    if (!m_factor.analyze(start, row, kModes, Ordering::NestedDissection, stop)) return Status::Stopped;
    auto value = m_factor.values().begin();
    for (int j = 0; j < A.rows(); ++j)
        for (int k = 0; k < kModes; ++k)
            for (int e = A.entryOf(j, j); e < A.begin(j + 1); ++e)
                for (int i = 0; i < kModes; ++i) *value++ = A.block(e)(k, i);  // the block of (j, column)
    switch (m_factor.factorize(FactorKind::Double, m_backEnd.workers(), stop)) {
        case Factor::Status::Done:
            return Status::Done;
        case Factor::Status::Stopped:
            return Status::Stopped;
        default:
            return Status::NotPositiveDefinite;
    }
}

template <int Dim>
typename Multigrid<Dim>::Status Multigrid<Dim>::build(const Points<Dim>& shape, const std::stop_token& stop) {
    if (!m_matrix.build(m_backEnd, stop)) return Status::Stopped;
    return buildNext<Dim>(m_finest, m_matrix.blocks(), linearMotions(shape), 0, stop);
}

/// level.z ≈ K⁻¹ level.r, which is spoilt: smoothed before and after the coarse correction by the same
/// polynomial, so that all of it is symmetric.
template <int Dim>
template <int Size>
bool Multigrid<Dim>::cycle(Level<Size, kModes>& level, const BlockRows<Size>& K, std::size_t next) {
    WorkerPool& workers = m_backEnd.workers();
    level.z.setZero(Size, K.rows());
    level.smoother.smooth(kDegree, true, K, level.r, level.z, m_links, workers);
    const bool last = next == m_coarse.size();
    level.prolongation.restrict(level.r, last ? m_r : m_coarse[next].r, workers);
    if (!(last ? solveCoarsest(m_r, m_z) : cycle<kModes>(m_coarse[next], m_coarse[next].matrix, next + 1)))
        return false;
    level.step.resize(Size, K.columns());
    level.prolongation.prolong(last ? m_z : m_coarse[next].z, level.step, workers);
    level.z += level.step.leftCols(K.rows());
    subtractProduct<Size>(K, level.step, level.r, workers);
    level.smoother.smooth(kDegree, false, K, level.r, level.z, m_links, workers);
    return true;
}

template <int Dim>
bool Multigrid<Dim>::solveCoarsest(const Points<kModes>& r, Points<kModes>& z) {
    z.resizeLike(r);
    const auto size = static_cast<std::size_t>(r.size());
    return m_factor.solve({r.data(), size}, {z.data(), size}, m_backEnd.workers());
}

template <int Dim>
bool Multigrid<Dim>::apply(std::span<const double> right, std::span<double> result) {
    const auto columns = static_cast<Eigen::Index>(m_system.unknowns().size());
    m_finest.r = Eigen::Map<const Points<Dim>>(right.data(), Dim, columns);
    if (!cycle<Dim>(m_finest, m_matrix.blocks(), 0)) return false;
    Eigen::Map<Points<Dim>>(result.data(), Dim, columns) = m_finest.z;
    return m_finest.z.allFinite();
}

template class Multigrid<2>;
template class Multigrid<3>;

}  // namespace wend
