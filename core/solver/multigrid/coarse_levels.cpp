#include "core/solver/multigrid/coarse_levels.h"

namespace wend {
namespace {

// Additions to the diagonal of the coarsest matrix, relative to it, tried in turn: the rigid motions of a
// body that is nearly free have less energy than the rounding of a matrix in single precision.
constexpr double kShifts[] = {0, 1e-7, 1e-5, 1e-3};

}  // namespace

template <int Modes>
void CoarseLevels<Modes>::analyze(Graph graph) {
    m_stages.clear();
    while (graph.size() * Modes > kFactored) {
        auto aggregates = aggregatesOf(graph);
        if (aggregates.count == graph.size()) break;
        graph = quotient(graph, aggregates);
        m_stages.emplace_back().aggregates = std::move(aggregates);
    }
}

template <int Modes>
BuildStatus CoarseLevels<Modes>::build(CoarseShare<Modes> share) {
    for (Stage& stage : m_stages) {
        stage.matrix = coarseMatrix<Modes>(share);
        const auto motions = std::move(share.motions);
        share = {};
        const auto status =
            stage.level.build(stage.matrix, stage.aggregates, motions, {}, m_links, m_workers, share);
        if (status != BuildStatus::Done) return status;
    }
    return factorize(coarseMatrix<Modes>(share));
}

/// Factorizes the matrix of the coarsest level.
template <int Modes>
BuildStatus CoarseLevels<Modes>::factorize(const BlockRows<Modes>& A) {
    std::vector<int> start{0}, row;
    for (int j = 0; j < A.rows(); ++j)
        for (int k = 0; k < Modes; ++k) {
            for (int e = A.entryOf(j, j); e < A.begin(j + 1); ++e)
                for (int i = 0; i < Modes; ++i) row.push_back(A.column(e) * Modes + i);
            start.push_back(static_cast<int>(row.size()));
        }
    if (!m_factor.analyze(start, row, Modes, Ordering::NestedDissection, m_workers.stop()))
        return BuildStatus::Stopped;
    auto status = Factor::Status::NotPositiveDefinite;
    for (const double shift : kShifts) {
        fill(A, shift);
        status = m_factor.factorize(FactorKind::Double, m_workers, m_workers.stop());
        if (status != Factor::Status::NotPositiveDefinite) break;
    }
    if (status == Factor::Status::Stopped) return BuildStatus::Stopped;
    return status == Factor::Status::Done ? BuildStatus::Done : BuildStatus::NotPositiveDefinite;
}

/// Copies the lower triangle of A + shift · diag A to the factor.
template <int Modes>
void CoarseLevels<Modes>::fill(const BlockRows<Modes>& A, double shift) {
    auto value = m_factor.values().begin();
    for (int j = 0; j < A.rows(); ++j)
        for (int k = 0; k < Modes; ++k)
            for (int e = A.entryOf(j, j); e < A.begin(j + 1); ++e)
                for (int i = 0; i < Modes; ++i) {
                    const bool isDiagonal = e == A.entryOf(j, j) && i == k;
                    *value++ = (isDiagonal ? 1 + shift : 1.0) * A.block(e)(k, i);  // the block of (j, column)
                }
}

template <int Modes>
bool CoarseLevels<Modes>::cycle(std::size_t level, Points<Modes>& r, Points<Modes>& z) {
    z.resizeLike(r);
    if (level == m_stages.size()) {
        const auto size = static_cast<std::size_t>(r.size());
        return m_factor.solve({r.data(), size}, {z.data(), size}, m_workers);
    }
    Stage& stage = m_stages[level];
    const auto solve = [&](const Points<Modes>& right, Points<Modes>& result) {
        stage.r = right;
        return cycle(level + 1, stage.r, result);
    };
    return stage.level.cycle(stage.matrix, r, z, solve, m_links, m_workers);
}

template class CoarseLevels<6>;
template class CoarseLevels<12>;

}  // namespace wend
