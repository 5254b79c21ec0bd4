#include "core/solver/multigrid/chebyshev.h"

#include <Eigen/Cholesky>
#include <array>
#include <cstdint>

#include "core/mesh/decompositions.h"

namespace wend {
namespace {

constexpr int kRowGrain = 512;  // rows
constexpr int kLanczosSteps = 10;
constexpr double kMargin = 1.15;  // over the estimate, which is from below
constexpr double kPart = 0.06;    // of the spectrum that is left to the coarse space

template <int Size>
double dotProduct(const Points<Size>& a, const Points<Size>& b) {
    return a.leftCols(b.cols()).cwiseProduct(b).sum();
}

/// Returns a number in [−1, 1[ by splitmix64.
double rough(std::uint64_t number) {
    std::uint64_t bits = number * 0x9E3779B97F4A7C15ULL;
    bits = (bits ^ bits >> 30) * 0xBF58476D1CE4E5B9ULL;
    bits = (bits ^ bits >> 27) * 0x94D049BB133111EBULL;
    return static_cast<double>((bits ^ bits >> 31) >> 11) * 0x1p-52 - 1;
}

/// Fills a field with numbers without a pattern, the same every time and however the system is divided.
template <int Size>
void makeRough(Points<Size>& x, const PartLinks& links) {
    for (Eigen::Index i = 0; i < x.cols(); ++i)
        for (int k = 0; k < Size; ++k)
            x(k, i) = rough(static_cast<std::uint64_t>(links.number(static_cast<int>(i))) * Size +
                            static_cast<unsigned>(k) + 1);
}

template <int Size>
void update(Points<Size>& x, const PartLinks& links) {
    links.update({x.data(), static_cast<std::size_t>(x.size())}, Size);
}

/// Calls visit(row, (K x)_row) for every row.
template <int Size, typename Visit>
void forProducts(const BlockRows<Size>& K, const Points<Size>& x, WorkerPool& workers, Visit&& visit) {
    workers.forPieces(K.rows(), kRowGrain, [&](int begin, int end) {
        std::array<double, static_cast<std::size_t>(kRowGrain) * Size> Kx;
        K.multiply(x, begin, end, Kx.data());
        for (int i = begin; i < end; ++i)
            visit(i, Eigen::Map<const Vec<Size>>(Kx.data() + static_cast<std::ptrdiff_t>(i - begin) * Size));
    });
}

}  // namespace

template <int Size>
void multiply(const BlockRows<Size>& K, const Points<Size>& x, Points<Size>& Kx, WorkerPool& workers) {
    Kx.resize(Size, K.rows());
    forProducts<Size>(K, x, workers, [&](int i, const auto& product) { Kx.col(i) = product; });
}

template <int Size>
void subtractProduct(const BlockRows<Size>& K, const Points<Size>& x, Points<Size>& r, WorkerPool& workers) {
    forProducts<Size>(K, x, workers, [&](int i, const auto& product) { r.col(i) -= product; });
}

/// Inverts the diagonal blocks by Cholesky's method; the diagonal is zero in held coordinates.
template <int Size>
bool Chebyshev<Size>::invertDiagonal(const BlockRows<Size>& K, const std::vector<unsigned>& held) {
    m_inverse.resize(K.rows());
    for (int i = 0; i < K.rows(); ++i) {
        Mat<Size> D = K.block(K.entryOf(i, i)).template cast<double>();
        const Eigen::LLT<Mat<Size>> factor(D);
        if (factor.info() != Eigen::Success) return false;
        D = factor.solve(Mat<Size>::Identity());
        const unsigned mask = held.empty() ? 0U : held[i];
        for (int k = 0; k < Size; ++k)
            if (mask >> k & 1U) D(k, k) = 0;
        m_inverse[i] = D.template cast<float>();
        if (!m_inverse[i].allFinite()) return false;
    }
    return true;
}

/// Estimates the eigenvalue by Lanczos' tridiagonal matrix, which conjugate gradients from a rough right-hand
/// side give. The side of the matrix is √β / α, its diagonal 1/α + β/α of the steps before. The estimate is
/// from below, hence the margin: an eigenvalue above the bound would be amplified.
template <int Size>
bool Chebyshev<Size>::prepare(const BlockRows<Size>& K, const std::vector<unsigned>& held,
                              const PartLinks& links, WorkerPool& workers) {
    if (!links.all(invertDiagonal(K, held))) return false;
    const auto applyInverse = [&](const Points<Size>& r, Points<Size>& z) {
        for (int i = 0; i < K.rows(); ++i)
            z.col(i).noalias() = m_inverse[i].template cast<double>() * r.col(i);
    };
    Points<Size> r(Size, K.rows()), z(Size, K.columns()), p, Kp;
    makeRough<Size>(r, links);
    applyInverse(r, z);
    update<Size>(z, links);
    multiply<Size>(K, z, r, workers);  // smooth parts count less in K z
    Eigen::VectorXd main(kLanczosSteps), side(kLanczosSteps);
    double rz = 0, alpha = 1, beta = 0;
    int steps = 0;
    for (; steps < kLanczosSteps; ++steps) {
        applyInverse(r, z);
        const double next = links.sum(dotProduct<Size>(z, r));
        if (!(next > 0)) break;
        beta = steps > 0 ? next / rz : 0;
        p = steps > 0 ? Points<Size>(z + beta * p) : z;
        update<Size>(p, links);
        rz = next;
        multiply<Size>(K, p, Kp, workers);
        const double pKp = links.sum(dotProduct<Size>(p, Kp));
        if (!(pKp > 0)) break;
        const double before = alpha;
        alpha = rz / pKp;
        main[steps] = 1 / alpha + (steps > 0 ? beta / before : 0);
        if (steps > 0) side[steps - 1] = std::sqrt(beta) / before;
        r -= alpha * Kp;
    }
    if (steps == 0) return false;
    m_largest = kMargin * largestEigenvalue(main.head(steps), side.head(std::max(0, steps - 1)));
    return std::isfinite(m_largest) && m_largest > 0;
}

/// Runs the three-term recurrence of Chebyshev's polynomials for the upper part of the spectrum. It damps
/// [kPart, 1] of the largest eigenvalue evenly (Saad, Iterative Methods for Sparse Linear Systems, 2003,
/// Algorithm 12.1); smoother parts are left to the coarse level. `degree` products with K are taken at most.
template <int Size>
void Chebyshev<Size>::smooth(int degree, bool residual, const BlockRows<Size>& K, Points<Size>& r,
                             Points<Size>& z, const PartLinks& links, WorkerPool& workers) {
    const double high = m_largest, low = kPart * m_largest, middle = 0.5 * (high + low),
                 half = 0.5 * (high - low), sigma = middle / half;
    double rho = 1 / sigma;
    m_d.resize(Size, K.columns());
    m_next.resize(Size, K.columns());
    workers.forPieces(K.rows(), kRowGrain, [&](int begin, int end) {
        for (int i = begin; i < end; ++i) {
            m_d.col(i) = m_inverse[i].template cast<double>() * r.col(i) / middle;
            z.col(i) += m_d.col(i);
        }
    });
    for (int i = 1; i < degree; ++i) {
        const double next = 1 / (2 * sigma - rho), keep = next * rho, add = 2 * next / half;
        update<Size>(m_d, links);
        forProducts<Size>(K, m_d, workers, [&](int row, const auto& Kd) {
            r.col(row) -= Kd;
            m_next.col(row) =
                keep * m_d.col(row) + add * (m_inverse[row].template cast<double>() * r.col(row));
            z.col(row) += m_next.col(row);
        });
        m_d.swap(m_next);
        rho = next;
    }
    if (!residual) return;
    update<Size>(m_d, links);
    subtractProduct<Size>(K, m_d, r, workers);
}

#define WEND_INSTANTIATE(Size)                                                                       \
    template class Chebyshev<Size>;                                                                  \
    template void multiply(const BlockRows<Size>&, const Points<Size>&, Points<Size>&, WorkerPool&); \
    template void subtractProduct(const BlockRows<Size>&, const Points<Size>&, Points<Size>&, WorkerPool&);
WEND_INSTANTIATE(2)
WEND_INSTANTIATE(3)
WEND_INSTANTIATE(6)
WEND_INSTANTIATE(12)

}  // namespace wend
