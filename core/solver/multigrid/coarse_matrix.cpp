#include "core/solver/multigrid/coarse_matrix.h"

#include <algorithm>
#include <numeric>

#include "core/solver/multigrid/numbering.h"

namespace wend {
namespace {

constexpr int kAggregateGrain = 16;  // aggregates

/// Rows of the lower triangle: of every row the number of its blocks, their columns, ascending, and values.
template <int Modes>
struct Lower {
    std::vector<int> count, columns;
    std::vector<Eigen::Matrix<float, Modes, Modes>> blocks;
};

/// C += A B, column by column.
template <class Left, class Right, class Sum>
void addProduct(const Left& A, const Right& B, Sum& C) {
    for (Eigen::Index j = 0; j < C.cols(); ++j) {
        typename Sum::ColXpr column = C.col(j);
        Eigen::Matrix<double, Sum::RowsAtCompileTime, 1> sum = column;
        for (Eigen::Index k = 0; k < A.cols(); ++k) sum += static_cast<double>(B(k, j)) * A.col(k);
        column = sum;
    }
}

/// (Pᵀ K) P in the row of an aggregate.
template <int Size, int Modes>
class LowerRow {
  public:
    LowerRow(const BlockRows<Size>& K, const Prolongation<Size, Modes>& P) : m_K(K), m_P(P) {}

    void append(int aggregate, Lower<Modes>& part) {
        multiplyLeft(aggregate);
        multiplyRight(aggregate);
        m_order.resize(m_columns.size());
        std::iota(m_order.begin(), m_order.end(), 0);
        std::sort(m_order.begin(), m_order.end(),
                  [&](int a, int b) { return m_columns.keys()[a] < m_columns.keys()[b]; });
        part.count.push_back(m_columns.size());
        for (int i : m_order) {
            part.columns.push_back(m_columns.keys()[i]);
            part.blocks.push_back(m_sums[i].template cast<float>());
        }
    }

  private:
    void multiplyLeft(int aggregate) {
        m_rows.clear();
        m_left.clear();
        for (int i = m_P.usersBegin(aggregate); i < m_P.usersBegin(aggregate + 1); ++i) {
            const Eigen::Matrix<double, Modes, Size> Pt =
                m_P.block(m_P.userEntry(i)).transpose().template cast<double>();
            for (int k = m_K.begin(m_P.user(i)); k < m_K.begin(m_P.user(i) + 1); ++k) {
                const int place = m_rows.of(m_K.column(k));
                if (place == static_cast<int>(m_left.size())) m_left.emplace_back().setZero();
                addProduct(Pt, m_K.block(k), m_left[place]);
            }
        }
    }

    void multiplyRight(int aggregate) {
        m_columns.clear();
        m_sums.clear();
        for (int i = 0; i < m_rows.size(); ++i) {
            const int row = m_rows.keys()[i];
            for (int e = m_P.begin(row); e < m_P.begin(row + 1); ++e) {
                if (m_P.aggregate(e) > aggregate) break;
                const int place = m_columns.of(m_P.aggregate(e));
                if (place == static_cast<int>(m_sums.size())) m_sums.emplace_back().setZero();
                addProduct(m_left[i], m_P.block(e), m_sums[place]);
            }
        }
    }

    const BlockRows<Size>& m_K;
    const Prolongation<Size, Modes>& m_P;
    Numbering m_rows, m_columns;
    std::vector<Eigen::Matrix<double, Modes, Size>> m_left;
    std::vector<Eigen::Matrix<double, Modes, Modes>> m_sums;
    std::vector<int> m_order;
};

template <int Modes, typename Visit>
void forBlocks(const std::vector<Lower<Modes>>& parts, Visit&& visit) {
    int row = 0;
    for (const auto& part : parts) {
        std::size_t next = 0;
        for (int count : part.count) {
            for (int i = 0; i < count; ++i, ++next) visit(row, part.columns[next], part.blocks[next]);
            ++row;
        }
    }
}

/// All rows, the upper triangle from the lower one: in a row that comes first.
template <int Modes>
BlockRows<Modes> whole(const std::vector<Lower<Modes>>& parts, int rows) {
    std::vector<int> start(static_cast<std::size_t>(rows) + 1, 0);
    forBlocks(parts, [&](int row, int column, const auto&) {
        ++start[row + 1];
        if (column != row) ++start[column + 1];
    });
    std::partial_sum(start.begin(), start.end(), start.begin());
    std::vector<int> columns(start.back());
    auto next = start;
    forBlocks(parts, [&](int row, int column, const auto&) {
        columns[next[row]++] = column;
        if (column != row) columns[next[column]++] = row;
    });
    next = start;
    BlockRows<Modes> A;
    A.setPattern(std::move(start), std::move(columns), rows);
    forBlocks(parts, [&](int row, int column, const auto& block) {
        A.block(next[row]++) = block;
        if (column != row) A.block(next[column]++) = block.transpose();
    });
    return A;
}

}  // namespace

template <int Size, int Modes>
BlockRows<Modes> coarseMatrix(const BlockRows<Size>& K, const Prolongation<Size, Modes>& P,
                              WorkerPool& workers, const std::stop_token& stop) {
    std::vector<Lower<Modes>> parts((P.aggregates() + kAggregateGrain - 1) / kAggregateGrain);
    workers.forPieces(P.aggregates(), kAggregateGrain, [&](int begin, int end) {
        LowerRow<Size, Modes> maker(K, P);
        for (int a = begin; a < end && !stop.stop_requested(); ++a)
            maker.append(a, parts[begin / kAggregateGrain]);
    });
    if (stop.stop_requested()) return {};
    auto A = whole<Modes>(parts, P.aggregates());
    for (int a = 0; a < A.rows(); ++a) {
        auto block = A.block(A.entryOf(a, a));
        block = (0.5F * (block + block.transpose())).eval();
        for (int k = 0; k < Modes; ++k)
            if (P.missing(a) >> k & 1U) block(k, k) = 1;
    }
    return A;
}

#define WEND_INSTANTIATE(Size, Modes)                                                                \
    template BlockRows<Modes> coarseMatrix(const BlockRows<Size>&, const Prolongation<Size, Modes>&, \
                                           WorkerPool&, const std::stop_token&);
WEND_INSTANTIATE(2, 6)
WEND_INSTANTIATE(6, 6)
WEND_INSTANTIATE(3, 12)
WEND_INSTANTIATE(12, 12)

}  // namespace wend
