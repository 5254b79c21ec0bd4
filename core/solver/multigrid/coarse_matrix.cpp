#include "core/solver/multigrid/coarse_matrix.h"

#include <algorithm>
#include <map>
#include <numeric>

#include "core/solver/multigrid/numbering.h"

namespace wend {
namespace {

constexpr int kAggregateGrain = 16;  // aggregates

/// Computes C += A B, column by column.
template <class Left, class Right, class Sum>
void addProduct(const Left& A, const Right& B, Sum& C) {
    for (Eigen::Index j = 0; j < C.cols(); ++j) {
        typename Sum::ColXpr column = C.col(j);
        Eigen::Matrix<double, Sum::RowsAtCompileTime, 1> sum = column;
        for (Eigen::Index k = 0; k < A.cols(); ++k) sum += static_cast<double>(B(k, j)) * A.col(k);
        column = sum;
    }
}

/// Computes (Pᵀ K) P in the row of an aggregate, its lower triangle only. Row by row the products need no
/// matrix Pᵀ K as a whole, and their sums run in the order of the rows of K.
template <int Size, int Modes>
class LowerRow {
  public:
    LowerRow(const BlockRows<Size>& K, const Prolongation<Size, Modes>& P) : m_K(K), m_P(P) {}

    /// Appends the row of an aggregate, whose columns are sorted by their number in the whole.
    void append(int aggregate, CoarseShare<Modes>& part) {
        multiplyLeft(aggregate);
        multiplyRight(aggregate);
        m_order.resize(m_columns.size());
        std::iota(m_order.begin(), m_order.end(), 0);
        std::sort(m_order.begin(), m_order.end(),
                  [&](int a, int b) { return m_columns.keys()[a] < m_columns.keys()[b]; });
        part.rows.push_back(m_P.number(aggregate));
        part.missing.push_back(m_P.missing(aggregate));
        part.count.push_back(m_columns.size());
        for (int i : m_order) {
            part.columns.push_back(m_P.number(m_columns.keys()[i]));
            part.blocks.push_back(m_sums[i].template cast<float>());
            if (m_K.columns() > m_K.rows())
                part.rests.push_back(
                    (m_sums[i] - part.blocks.back().template cast<double>()).template cast<float>());
        }
    }

  private:
    /// Computes the row of Pᵀ K: one Modes × Size block for every column of K that the aggregate's rows have.
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

    /// Computes the row's product with P, up to the diagonal.
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
void forBlocks(const CoarseShare<Modes>& share, Visit&& visit) {
    std::size_t next = 0;
    for (std::size_t i = 0; i < share.rows.size(); ++i)
        for (int k = 0; k < share.count[i]; ++k, ++next)
            visit(share.rows[i], share.columns[next], share.blocks[next]);
}

/// Returns the matrix with all columns of each row: blocks above the diagonal are the transposes of those
/// below, and follow these in their row.
template <int Modes>
BlockRows<Modes> whole(const CoarseShare<Modes>& share) {
    const int rows = static_cast<int>(share.rows.size());
    std::vector<int> start(share.rows.size() + 1, 0);
    forBlocks(share, [&](int row, int column, const auto&) {
        ++start[row + 1];
        if (column != row) ++start[column + 1];
    });
    std::partial_sum(start.begin(), start.end(), start.begin());
    std::vector<int> columns(start.back());
    auto next = start;
    forBlocks(share, [&](int row, int column, const auto&) {
        columns[next[row]++] = column;
        if (column != row) columns[next[column]++] = row;
    });
    next = start;
    BlockRows<Modes> A;
    A.setPattern(std::move(start), std::move(columns), rows);
    forBlocks(share, [&](int row, int column, const auto& block) {
        A.block(next[row]++) = block;
        if (column != row) A.block(next[column]++) = block.transpose();
    });
    return A;
}

template <class List>
void append(List& list, List& more) {
    list.insert(list.end(), more.begin(), more.end());
    more = {};
}

}  // namespace

template <int Size, int Modes>
CoarseShare<Modes> coarseShare(const BlockRows<Size>& K, const Prolongation<Size, Modes>& P,
                               WorkerPool& workers) {
    std::vector<CoarseShare<Modes>> pieces((P.aggregates() + kAggregateGrain - 1) / kAggregateGrain);
    workers.forPieces(P.aggregates(), kAggregateGrain, [&](int begin, int end) {
        LowerRow<Size, Modes> maker(K, P);
        for (int a = begin; a < end; ++a) maker.append(a, pieces[begin / kAggregateGrain]);
    });
    CoarseShare<Modes> share;
    share.own = P.ownAggregates();
    for (auto& piece : pieces) {
        append(share.rows, piece.rows);
        append(share.count, piece.count);
        append(share.columns, piece.columns);
        append(share.missing, piece.missing);
        append(share.blocks, piece.blocks);
        append(share.rests, piece.rests);
    }
    return share;
}

/// Merges the sorted rows of all shares, adding up blocks of the same row and column in the order of the
/// parts.
template <int Modes>
CoarseShare<Modes> merged(const std::vector<CoarseShare<Modes>>& shares) {
    using Square = Eigen::Matrix<double, Modes, Modes>;
    CoarseShare<Modes> result;
    int rows = 0;
    for (const auto& share : shares)
        if (!share.rows.empty()) rows = std::max(rows, share.rows.back() + 1);
    std::vector<std::size_t> row(shares.size(), 0), entry(shares.size(), 0);
    std::map<int, Square> sums;
    for (int number = 0; number < rows; ++number) {
        sums.clear();
        unsigned missing = 0;
        for (std::size_t s = 0; s < shares.size(); ++s) {
            const auto& share = shares[s];
            if (row[s] == share.rows.size() || share.rows[row[s]] != number) continue;
            missing |= share.missing[row[s]];
            for (int i = 0; i < share.count[row[s]]; ++i, ++entry[s]) {
                Square& sum = sums.try_emplace(share.columns[entry[s]], Square::Zero()).first->second;
                sum += share.blocks[entry[s]].template cast<double>();
                if (!share.rests.empty()) sum += share.rests[entry[s]].template cast<double>();
            }
            ++row[s];
        }
        result.rows.push_back(number);
        result.missing.push_back(missing);
        result.count.push_back(static_cast<int>(sums.size()));
        for (const auto& [column, block] : sums) {
            result.columns.push_back(column);
            result.blocks.push_back(block.template cast<float>());
        }
    }
    return result;
}

template <int Modes>
BlockRows<Modes> coarseMatrix(const CoarseShare<Modes>& share) {
    auto A = whole<Modes>(share);
    for (int a = 0; a < A.rows(); ++a) {
        auto block = A.block(A.entryOf(a, a));
        block = (0.5F * (block + block.transpose())).eval();
        for (int k = 0; k < Modes; ++k)
            if (share.missing[a] >> k & 1U) block(k, k) = 1;
    }
    return A;
}

#define WEND_INSTANTIATE(Size, Modes)                                                                 \
    template CoarseShare<Modes> coarseShare(const BlockRows<Size>&, const Prolongation<Size, Modes>&, \
                                            WorkerPool&);
WEND_INSTANTIATE(2, 6)
WEND_INSTANTIATE(6, 6)
WEND_INSTANTIATE(3, 12)
WEND_INSTANTIATE(12, 12)
template CoarseShare<6> merged(const std::vector<CoarseShare<6>>&);
template CoarseShare<12> merged(const std::vector<CoarseShare<12>>&);
template BlockRows<6> coarseMatrix(const CoarseShare<6>&);
template BlockRows<12> coarseMatrix(const CoarseShare<12>&);

}  // namespace wend
