#include "core/solver/multigrid/prolongation.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/solver/multigrid/numbering.h"

namespace wend {
namespace {

constexpr int kProlongationGrain = 256;
constexpr double kSmoothingShare = 0.3;  // of the time that the levels take from there on
constexpr double kDamping = 4.0 / 3;     // of the inverse of the largest eigenvalue
// A motion of an aggregate that is so nearly a sum of others, relative to its size squared, is left out.
constexpr double kDependent = 1e-10;

void sortUnique(std::vector<int>& list) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
}

/// Returns the place of a number in an ascending list that has it.
int placeIn(const std::vector<int>& list, int number) {
    return static_cast<int>(std::lower_bound(list.begin(), list.end(), number) - list.begin());
}

/// Factorizes G = L Lᵀ of Gram's matrix of the motions. Motions without a pivot depend on those before; their
/// columns are 0, and their bits are set in the result.
template <class Square>
unsigned factorize(const Square& G, Square& L) {
    unsigned missing = 0;
    L.setZero();
    for (int j = 0; j < G.cols(); ++j) {
        const double d = G(j, j) - L.row(j).head(j).squaredNorm();
        if (!(d > kDependent * G(j, j))) {
            missing |= 1U << j;
            continue;
        }
        L(j, j) = std::sqrt(d);
        for (int i = j + 1; i < G.rows(); ++i)
            L(i, j) = (G(i, j) - L.row(i).head(j).dot(L.row(j).head(j))) / L(j, j);
    }
    return missing;
}

/// Returns Q with B = Q Lᵀ, whose columns are orthonormal within an aggregate; columns that are missing are
/// 0.
template <class Motions, class Square>
Motions orthonormal(const Motions& B, const Square& L, unsigned missing) {
    Motions Q = B;
    for (int j = 0; j < L.cols(); ++j) {
        for (int k = 0; k < j; ++k) Q.col(j) -= L(j, k) * Q.col(k);
        if (missing >> j & 1U)
            Q.col(j).setZero();
        else
            Q.col(j) /= L(j, j);
    }
    return Q;
}

}  // namespace

/// Orthonormalizes the motions within every aggregate; those that depend on others are missing. The motions
/// as coarse fields are Lᵀ of the factorization G = L Lᵀ of their Gram matrix, since B = Q Lᵀ.
template <int Size, int Modes>
auto Prolongation<Size, Modes>::makeMotions(const Aggregates& aggregates, const std::vector<Motions>& motions)
    -> std::vector<Square> {
    m_own = aggregates.of;
    sortUnique(m_own);
    std::vector<int> place;
    place.reserve(motions.size());
    for (int number : aggregates.of) place.push_back(placeIn(m_own, number));
    std::vector<Square> G(m_own.size(), Square::Zero());
    for (std::size_t i = 0; i < motions.size(); ++i) G[place[i]] += motions[i].transpose() * motions[i];
    m_ownMissing.resize(G.size());
    for (std::size_t a = 0; a < G.size(); ++a) {
        Square L;
        m_ownMissing[a] = factorize(G[a], L);
        G[a] = L;
    }
    m_start.resize(motions.size() + 1);
    std::iota(m_start.begin(), m_start.end(), 0);
    m_aggregate = aggregates.of;
    m_blocks.resize(motions.size());
    for (std::size_t i = 0; i < motions.size(); ++i) {
        const int a = place[i];
        m_blocks[i] = orthonormal(motions[i], G[a], m_ownMissing[a]).template cast<float>();
    }
    for (Square& L : G) L.transposeInPlace();
    return G;
}

/// Computes P ← (I − ω D⁻¹ K) P. D⁻¹ is 0 in coordinates that are held. One step of Jacobi's method spreads
/// every motion to the neighbours of its aggregate, and takes away the jumps at its boundary, which would
/// cost much energy. The rows are made in pieces and joined in their order, since their lengths are not known
/// before.
template <int Size, int Modes>
void Prolongation<Size, Modes>::smooth(double damping, const BlockRows<Size>& K,
                                       const Chebyshev<Size>& smoother, WorkerPool& workers) {
    struct Piece {
        std::vector<int> aggregates;
        std::vector<Block> blocks;
    };
    std::vector<Piece> pieces((K.rows() + kProlongationGrain - 1) / kProlongationGrain);
    std::vector<int> start(static_cast<std::size_t>(K.rows()) + 1, 0);
    workers.forPieces(K.rows(), kProlongationGrain, [&](int begin, int end) {
        Piece& piece = pieces[begin / kProlongationGrain];
        Numbering places;
        std::vector<Motions> sums;
        std::vector<int> order;
        const auto at = [&](int aggregate) -> Motions& {
            const int place = places.of(aggregate);
            if (place == static_cast<int>(sums.size())) sums.push_back(Motions::Zero());
            return sums[place];
        };
        for (int row = begin; row < end; ++row) {
            places.clear();
            sums.clear();
            for (int k = K.begin(row); k < K.begin(row + 1); ++k) {
                const Mat<Size> A = K.block(k).template cast<double>();
                const int column = K.column(k);
                for (int e = m_start[column]; e < m_start[column + 1]; ++e)
                    at(m_aggregate[e]) += A.lazyProduct(m_blocks[e].template cast<double>());
            }
            const Mat<Size> step = damping * smoother.inverse(row).template cast<double>();
            for (Motions& sum : sums) sum = (-step.lazyProduct(sum)).eval();
            for (int e = m_start[row]; e < m_start[row + 1]; ++e)
                at(m_aggregate[e]) += m_blocks[e].template cast<double>();
            order.resize(places.size());
            std::iota(order.begin(), order.end(), 0);
            std::sort(order.begin(), order.end(),
                      [&](int a, int b) { return places.keys()[a] < places.keys()[b]; });
            for (int i : order) {
                piece.aggregates.push_back(places.keys()[i]);
                piece.blocks.push_back(sums[i].template cast<float>());
            }
            start[row + 1] = static_cast<int>(order.size());
        }
    });
    std::partial_sum(start.begin(), start.end(), start.begin());
    m_start = std::move(start);
    m_aggregate = {};
    m_blocks = {};
    m_aggregate.reserve(m_start.back());
    m_blocks.reserve(m_start.back());
    for (Piece& piece : pieces) {
        m_aggregate.insert(m_aggregate.end(), piece.aggregates.begin(), piece.aggregates.end());
        m_blocks.insert(m_blocks.end(), piece.blocks.begin(), piece.blocks.end());
        piece = {};
    }
}

/// Appends the rows of unknowns of other parts.
template <int Size, int Modes>
void Prolongation<Size, Modes>::addCopies(const PartLinks& links) {
    constexpr int kNumbers = Size * Modes;
    const std::span<const float> values(m_blocks.empty() ? nullptr : m_blocks.front().data(),
                                        m_blocks.size() * kNumbers);
    const PartLinks::Rows rows = links.copiedRows(m_start, m_aggregate, values, kNumbers);
    for (int count : rows.count) m_start.push_back(m_start.back() + count);
    m_aggregate.insert(m_aggregate.end(), rows.columns.begin(), rows.columns.end());
    for (std::size_t i = 0; i < rows.columns.size(); ++i)
        m_blocks.push_back(Eigen::Map<const Block>(rows.values.data() + i * kNumbers));
}

/// Replaces numbers in the whole by those of the aggregates that the rows have.
template <int Size, int Modes>
void Prolongation<Size, Modes>::renumber() {
    m_numbers = m_aggregate;
    sortUnique(m_numbers);
    for (int& a : m_aggregate) a = placeIn(m_numbers, a);
    m_missing.assign(m_numbers.size(), 0);
    for (std::size_t i = 0; i < m_own.size(); ++i) m_missing[placeIn(m_numbers, m_own[i])] = m_ownMissing[i];
}

template <int Size, int Modes>
void Prolongation<Size, Modes>::listUsers(int rows) {
    m_usersStart.assign(m_numbers.size() + 1, 0);
    for (int e = 0; e < m_start[rows]; ++e) ++m_usersStart[m_aggregate[e] + 1];
    std::partial_sum(m_usersStart.begin(), m_usersStart.end(), m_usersStart.begin());
    m_users.resize(m_start[rows]);
    m_userEntries.resize(m_start[rows]);
    auto next = m_usersStart;
    for (int row = 0; row < rows; ++row)
        for (int e = m_start[row]; e < m_start[row + 1]; ++e) {
            const int place = next[m_aggregate[e]]++;
            m_users[place] = row;
            m_userEntries[place] = e;
        }
}

template <int Size, int Modes>
auto Prolongation<Size, Modes>::build(const Aggregates& aggregates, const std::vector<Motions>& motions,
                                      const BlockRows<Size>& K, const Chebyshev<Size>& smoother,
                                      WorkerPool& workers, const PartLinks& links) -> std::vector<Square> {
    m_rows = K.rows();
    auto coarse = makeMotions(aggregates, motions);
    addCopies(links);
    workers.measureNext(kSmoothingShare);
    smooth(kDamping / smoother.largest(), K, smoother, workers);
    if (links.decide(workers.isStopped())) return coarse;
    addCopies(links);
    renumber();
    listUsers(m_rows);
    return coarse;
}

template <int Size, int Modes>
void Prolongation<Size, Modes>::restrict(const Points<Size>& r, Points<Modes>& coarse,
                                         WorkerPool& workers) const {
    coarse.resize(Modes, aggregates());
    workers.forPieces(aggregates(), kProlongationGrain / 4, [&](int begin, int end) {
        for (int a = begin; a < end; ++a) {
            Vec<Modes> sum = Vec<Modes>::Zero();
            for (int i = m_usersStart[a]; i < m_usersStart[a + 1]; ++i)
                for (int k = 0; k < Size; ++k)
                    sum += r(k, m_users[i]) *
                           m_blocks[m_userEntries[i]].row(k).transpose().template cast<double>();
            coarse.col(a) = sum;
        }
    });
}

template <int Size, int Modes>
void Prolongation<Size, Modes>::prolong(const Points<Modes>& coarse, Points<Size>& z,
                                        WorkerPool& workers) const {
    workers.forPieces(m_rows, kProlongationGrain, [&](int begin, int end) {
        for (int i = begin; i < end; ++i) {
            Vec<Size> sum = Vec<Size>::Zero();
            for (int e = m_start[i]; e < m_start[i + 1]; ++e)
                sum += m_blocks[e].template cast<double>() * coarse.col(m_aggregate[e]);
            z.col(i) = sum;
        }
    });
}

template class Prolongation<2, 6>;
template class Prolongation<6, 6>;
template class Prolongation<3, 12>;
template class Prolongation<12, 12>;

}  // namespace wend
