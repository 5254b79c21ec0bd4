#include "core/solver/multigrid/chebyshev.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <cstdint>

namespace wend {
namespace {

constexpr int kGrain = 1024;
constexpr int kLanczosSteps = 10;
constexpr double kMargin = 1.15;  // over the estimate, which is from below
constexpr double kPart = 0.06;    // of the spectrum that is left to the coarse space

template <int Dim>
double dot(const Points<Dim>& a, const Points<Dim>& b) {
    return a.cwiseProduct(b).sum();
}

/// Numbers in [−1, 1[ without a pattern, the same every time.
template <int Dim>
Points<Dim> rough(Eigen::Index columns) {
    Points<Dim> x(Dim, columns);
    std::uint64_t state = 0x9E3779B97F4A7C15ULL;
    for (Eigen::Index i = 0; i < x.size(); ++i) {
        state = state * 6364136223846793005ULL + 1442695040888963407ULL;
        x.data()[i] = static_cast<double>(state >> 11) * 0x1p-52 - 1;
    }
    return x;
}

}  // namespace

template <int Dim>
void Chebyshev<Dim>::applyInverse(const Points<Dim>& r, Points<Dim>& z, WorkerPool& workers) const {
    z.resize(Dim, r.cols());
    workers.forPieces(static_cast<int>(r.cols()), kGrain, [&](int begin, int end) {
        for (int i = begin; i < end; ++i) z.col(i).noalias() = m_inverse[i] * r.col(i);
    });
}

template <int Dim>
bool Chebyshev<Dim>::prepare(std::vector<Mat<Dim>> diagonal, const std::vector<unsigned>& held,
                             const Product& product, WorkerPool& workers) {
    m_inverse = std::move(diagonal);
    for (std::size_t i = 0; i < m_inverse.size(); ++i) {
        Mat<Dim>& D = m_inverse[i];
        const unsigned mask = held.empty() ? 0U : held[i];
        for (int k = 0; k < Dim; ++k)
            if (mask >> k & 1U) {
                D.row(k).setZero();
                D.col(k).setZero();
                D(k, k) = 1;
            }
        const Eigen::LLT<Mat<Dim>> factor(D);
        if (factor.info() != Eigen::Success) return false;
        D = factor.solve(Mat<Dim>::Identity());
        for (int k = 0; k < Dim; ++k)
            if (mask >> k & 1U) D(k, k) = 0;
    }
    // Conjugate gradients from a rough right-hand side give Lanczos' tridiagonal matrix.
    const auto columns = static_cast<Eigen::Index>(m_inverse.size());
    Points<Dim> r, z, p, Kp;
    applyInverse(rough<Dim>(columns), z, workers);
    product(z, r);  // smooth parts count less in K z
    Eigen::VectorXd main(kLanczosSteps), side(kLanczosSteps);
    double rz = 0, alpha = 1, beta = 0;
    int steps = 0;
    for (; steps < kLanczosSteps; ++steps) {
        applyInverse(r, z, workers);
        const double next = dot<Dim>(r, z);
        if (!(next > 0)) break;
        beta = steps > 0 ? next / rz : 0;
        p = steps > 0 ? Points<Dim>(z + beta * p) : z;
        rz = next;
        product(p, Kp);
        const double pKp = dot<Dim>(p, Kp);
        if (!(pKp > 0)) break;
        const double before = alpha;
        alpha = rz / pKp;
        main[steps] = 1 / alpha + (steps > 0 ? beta / before : 0);
        if (steps > 0) side[steps - 1] = std::sqrt(beta) / before;
        r -= alpha * Kp;
    }
    if (steps == 0) return false;
    Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver;
    solver.computeFromTridiagonal(main.head(steps), side.head(std::max(0, steps - 1)),
                                  Eigen::EigenvaluesOnly);
    m_largest = kMargin * solver.eigenvalues().maxCoeff();
    return std::isfinite(m_largest) && m_largest > 0;
}

template <int Dim>
void Chebyshev<Dim>::smooth(int degree, bool residual, const Product& product, Points<Dim>& r, Points<Dim>& z,
                            WorkerPool& workers) {
    const double high = m_largest, low = kPart * m_largest, middle = 0.5 * (high + low),
                 half = 0.5 * (high - low), sigma = middle / half;
    double rho = 1 / sigma;
    applyInverse(r, m_d, workers);
    m_d /= middle;
    z += m_d;
    for (int i = 1; i < degree; ++i) {
        product(m_d, m_Kd);
        r -= m_Kd;
        applyInverse(r, m_s, workers);
        const double next = 1 / (2 * sigma - rho);
        m_d = next * rho * m_d + (2 * next / half) * m_s;
        rho = next;
        z += m_d;
    }
    if (!residual) return;
    product(m_d, m_Kd);
    r -= m_Kd;
}

template class Chebyshev<2>;
template class Chebyshev<3>;

}  // namespace wend
