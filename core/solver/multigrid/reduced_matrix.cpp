#include "core/solver/multigrid/reduced_matrix.h"

#include <algorithm>
#include <numeric>

#include "core/solver/multigrid/numbering.h"

namespace wend {
namespace {

constexpr int kReducedGrain = 512;    // rows
constexpr double kMatrixShare = 0.2;  // of the time that all levels take

}  // namespace

/// Makes rows of K, one after the other.
template <int Dim>
class ReducedMatrix<Dim>::Rows {
    static constexpr int kCorners = Dim + 1;

  public:
    explicit Rows(const ReducedMatrix& matrix) : m_matrix(matrix), m_plan(*matrix.m_plan) {}

    /// Appends the columns of a row.
    void appendColumns(int row, std::vector<int>& columns) {
        m_columns.clear();
        forSources(row, [&](int vertex, double) {
            collect(vertex);
            for (int q : m_vertices.keys())
                m_matrix.m_system->forUnknowns(q, [&](int Q, double) { m_columns.of(Q); });
        });
        const auto first = columns.insert(columns.end(), m_columns.keys().begin(), m_columns.keys().end());
        std::sort(first, columns.end());
    }

    /// Computes K_PQ = Σ z_pP z_qQ A_pq.
    void compute(int row, const BlockSource& source, BlockRows<Dim>& out) {
        const int begin = out.begin(row), count = out.begin(row + 1) - begin;
        m_columns.clear();
        for (int i = 0; i < count; ++i) m_columns.of(out.column(begin + i));
        m_sums.assign(count, Mat<Dim>::Zero());
        forSources(row, [&](int vertex, double zP) {
            collect(vertex);
            sortContributions();
            m_blocks.resize(m_vertices.size());
            source.compute(m_blockStart, m_sorted.data(), m_blocks.front().data());
            for (int i = 0; i < m_vertices.size(); ++i)
                m_matrix.m_system->forUnknowns(m_vertices.keys()[i], [&](int Q, double zQ) {
                    m_sums[m_columns.of(Q)] += zP * zQ * m_blocks[i];
                });
        });
        for (int i = 0; i < count; ++i) {
            release(row, out.column(begin + i), m_sums[i]);
            out.block(begin + i) = m_sums[i].template cast<float>();
        }
    }

  private:
    /// Calls visit(vertex, coefficient) for every vertex that depends on an unknown.
    template <typename Visit>
    void forSources(int unknown, Visit&& visit) {
        visit(m_matrix.m_system->unknowns()[unknown], 1.0);
        if (m_matrix.m_followerStart.empty()) return;
        for (int i = m_matrix.m_followerStart[unknown]; i < m_matrix.m_followerStart[unknown + 1]; ++i)
            visit(m_matrix.m_followers[i].first, m_matrix.m_followers[i].second);
    }

    /// Collects the contributions to the row of a vertex in A, and its columns.
    void collect(int vertex) {
        m_vertices.clear();
        m_contributions.clear();
        m_places.clear();
        const auto add = [&](int corner, int cell, int term) {
            for (int k = 0; k < kCorners; ++k) {
                m_places.push_back(m_vertices.of(m_plan.cells[cell][k]));
                m_contributions.push_back({corner, cell * kCorners + k, term});
            }
        };
        for (int i = m_plan.cornerStart[vertex]; i < m_plan.cornerStart[vertex + 1]; ++i) {
            const int corner = m_plan.corners[i], cell = corner / kCorners;
            add(corner, cell, cell);
            for (int facet : m_plan.facetOfCorner[cell])
                if (facet >= 0) add(corner, m_plan.across(facet, cell), m_plan.cellCount() + facet);
        }
    }

    /// Sorts the contributions by column, otherwise in their order.
    void sortContributions() {
        m_blockStart.assign(static_cast<std::size_t>(m_vertices.size()) + 1, 0);
        for (int place : m_places) ++m_blockStart[place + 1];
        std::partial_sum(m_blockStart.begin(), m_blockStart.end(), m_blockStart.begin());
        m_next.assign(m_blockStart.begin(), m_blockStart.end());
        m_sorted.resize(m_contributions.size());
        for (std::size_t i = 0; i < m_places.size(); ++i)
            m_sorted[m_next[m_places[i]]++] = m_contributions[i];
    }

    void release(int row, int column, Mat<Dim>& K) const {
        const auto& held = m_matrix.m_system->held();
        if (held.empty()) return;
        for (int i = 0; i < Dim; ++i)
            for (int j = 0; j < Dim; ++j)
                if (((held[row] >> i | held[column] >> j) & 1U) && !(row == column && i == j)) K(i, j) = 0;
    }

    const ReducedMatrix& m_matrix;
    const AssemblyPlan<Dim>& m_plan;
    Numbering m_vertices, m_columns;
    std::vector<int> m_places, m_blockStart, m_next;
    std::vector<Contribution> m_contributions, m_sorted;
    std::vector<Mat<Dim>> m_blocks, m_sums;
};

template <int Dim>
void ReducedMatrix<Dim>::analyze(const AssemblyPlan<Dim>& plan, const ReducedSystem<Dim>& system, int rows,
                                 WorkerPool& workers) {
    m_plan = &plan;
    m_system = &system;
    std::vector<std::vector<std::pair<int, double>>> followers;
    for (const auto& pivot : system.elimination().pivots)
        system.forUnknowns(pivot.vertex, [&](int unknown, double z) {
            followers.resize(system.unknowns().size());
            followers[unknown].emplace_back(pivot.vertex, z);
        });
    m_followerStart.assign(followers.empty() ? 0 : 1, 0);
    m_followers.clear();
    for (const auto& list : followers) {
        m_followers.insert(m_followers.end(), list.begin(), list.end());
        m_followerStart.push_back(static_cast<int>(m_followers.size()));
    }

    std::vector<std::vector<int>> pieces((rows + kReducedGrain - 1) / kReducedGrain);
    std::vector<int> start(static_cast<std::size_t>(rows) + 1, 0);
    workers.forPieces(rows, kReducedGrain, [&](int begin, int end) {
        Rows maker(*this);
        auto& columns = pieces[begin / kReducedGrain];
        for (int row = begin; row < end; ++row) {
            const std::size_t before = columns.size();
            maker.appendColumns(row, columns);
            start[row + 1] = static_cast<int>(columns.size() - before);
        }
    });
    std::partial_sum(start.begin(), start.end(), start.begin());
    std::vector<int> all;
    all.reserve(start.back());
    for (auto& columns : pieces) {
        all.insert(all.end(), columns.begin(), columns.end());
        columns = {};
    }
    m_blocks.setPattern(std::move(start), std::move(all), static_cast<int>(system.unknowns().size()));
}

template <int Dim>
bool ReducedMatrix<Dim>::build(BackEnd<Dim>& backEnd) {
    const auto source = backEnd.blockSource();
    backEnd.workers().measureNext(kMatrixShare);
    backEnd.workers().forPieces(m_blocks.rows(), kReducedGrain, [&](int begin, int end) {
        Rows maker(*this);
        for (int row = begin; row < end; ++row) maker.compute(row, *source, m_blocks);
    });
    return !backEnd.workers().isStopped();
}

template class ReducedMatrix<2>;
template class ReducedMatrix<3>;

}  // namespace wend
