#include "core/solver/multigrid/level.h"

namespace wend {
namespace {

constexpr int kDegree = 3;              // of the smoother, before and after the coarse correction
constexpr double kProductsShare = 0.6;  // of the time that the levels take from there on

}  // namespace

template <int Size, int Modes>
BuildStatus Level<Size, Modes>::build(const BlockRows<Size>& K, const Aggregates& aggregates,
                                      const std::vector<Motions>& motions, const std::vector<unsigned>& held,
                                      const PartLinks& links, WorkerPool& workers,
                                      CoarseShare<Modes>& share) {
    const auto stopped = [&] { return links.decide(workers.isStopped()); };
    const bool prepared = m_smoother.prepare(K, held, links, workers);
    if (stopped()) return BuildStatus::Stopped;
    if (!prepared) return BuildStatus::NotPositiveDefinite;
    auto coarseMotions = m_prolongation.build(aggregates, motions, K, m_smoother, workers, links);
    if (stopped()) return BuildStatus::Stopped;
    workers.measureNext(kProductsShare);
    share = coarseShare<Size, Modes>(K, m_prolongation, workers);
    share.motions = std::move(coarseMotions);
    return stopped() ? BuildStatus::Stopped : BuildStatus::Done;
}

template <int Size, int Modes>
bool Level<Size, Modes>::cycle(const BlockRows<Size>& K, Points<Size>& r, Points<Size>& z,
                               const CoarseSolve& solve, const PartLinks& links, WorkerPool& workers) {
    const auto stopped = [&] { return links.decide(workers.isStopped()); };
    z.setZero(Size, K.rows());
    m_smoother.smooth(kDegree, true, K, r, z, links, workers);
    if (stopped()) return false;
    m_prolongation.restrict(r, m_right, workers);
    m_coarse.resizeLike(m_right);
    if (!solve(m_right, m_coarse)) return false;
    m_step.setZero(Size, K.columns());
    m_prolongation.prolong(m_coarse, m_step, workers);
    z += m_step.leftCols(K.rows());
    links.update({m_step.data(), static_cast<std::size_t>(m_step.size())}, Size);
    subtractProduct<Size>(K, m_step, r, workers);
    m_smoother.smooth(kDegree, false, K, r, z, links, workers);
    return !stopped();
}

template class Level<2, 6>;
template class Level<6, 6>;
template class Level<3, 12>;
template class Level<12, 12>;

}  // namespace wend
