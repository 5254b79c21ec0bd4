#include "core/energy/cell_energy.h"

#include <Eigen/LU>
#include <cmath>

namespace wend {
namespace {

/// Returns A + Aᵀ entry by entry, which is exactly symmetric (g++ 12 warns of Eigen's J + J.transpose()).
template <int N>
Eigen::Matrix<double, N, N> plusTranspose(const Eigen::Matrix<double, N, N>& A) {
    Eigen::Matrix<double, N, N> S;
    for (int a = 0; a < N; ++a)
        for (int b = 0; b < N; ++b) S(a, b) = A(a, b) + A(b, a);
    return S;
}

}  // namespace

template <int Dim>
Mat<Dim> edgeMatrix(const Points<Dim>& points, const Cell<Dim>& cell) {
    Mat<Dim> edges;
    for (int k = 0; k < Dim; ++k) edges.col(k) = points.col(cell[k + 1]) - points.col(cell[0]);
    return edges;
}

/// Computes the gradients of the corners 1 … d as the rows of E⁻¹; corner 0 has minus their sum.
template <int Dim>
CellGeometry<Dim> cellGeometry(const Points<Dim>& points, const Cell<Dim>& cell) {
    constexpr double kFactorial = Dim == 2 ? 2 : 6;
    const Mat<Dim> edges = edgeMatrix<Dim>(points, cell);
    CellGeometry<Dim> geometry;
    geometry.measure = edges.determinant() / kFactorial;
    // The rows of the inverse are the gradients of the barycentric coordinates 1 … d; all of them sum to
    // zero.
    geometry.gradients.template rightCols<Dim>() = edges.inverse().transpose();
    geometry.gradients.col(0) = -geometry.gradients.template rightCols<Dim>().rowwise().sum();
    return geometry;
}

EnergyWeights EnergyWeights::of(double phi) {
    return {std::sin(phi), std::cos(phi)};
}

template <int Dim>
double energyDensity(EnergyWeights w, const Mat<Dim>& B, const Mat<Dim>& J) {
    const Mat<Dim> S = plusTranspose<Dim>(J);
    const double trBJ = (B * J).trace();
    return w.q * (S.transpose() * B * S).trace() + w.r * (Dim / B.trace()) * trBJ * trBJ;
}

template <int Dim>
Mat<Dim> stress(EnergyWeights w, const Mat<Dim>& B, const Mat<Dim>& J) {
    const Mat<Dim> S = plusTranspose<Dim>(J);
    return 2 * w.q * (S * B + B * S) + 2 * w.r * (Dim / B.trace()) * (B * J).trace() * B;
}

template <int Dim>
StressMatrix<Dim> stressMatrix(EnergyWeights w, const Mat<Dim>& B) {
    const Strain<Dim> b = toMandel<Dim>(B);
    StressMatrix<Dim> D = w.r * (Dim / B.trace()) * b * b.transpose();  // Tr BJ = ½ B : S
    for (int i = 0; i < kStrainCount<Dim>; ++i) {
        const Mat<Dim> S = fromMandel<Dim>(Strain<Dim>::Unit(i));
        D.col(i) += 2 * w.q * toMandel<Dim>(S * B + B * S);
    }
    return 0.5 * plusTranspose<kStrainCount<Dim>>(D);  // symmetric to the last bit
}

template <int Dim>
Mat<Dim> stressBlock(EnergyWeights w, const Mat<Dim>& B, const Vec<Dim>& g, const Vec<Dim>& h) {
    const Vec<Dim> Bg = B * g, Bh = B * h;
    Mat<Dim> K = 4 * w.q * (Bh * g.transpose() + g.dot(h) * B + h * Bg.transpose());
    K.diagonal().array() += 4 * w.q * g.dot(Bh);
    if (w.r != 0) K += 4 * w.r * (Dim / B.trace()) * Bg * Bh.transpose();
    return K;
}

namespace {

/// Returns the normalized conformal part (c, −s; s, c) of F, c = F₀₀ + F₁₁ and s = F₁₀ − F₀₁, which in the
/// plane is the nearest rotation. Its length is the sum of the singular values, hence positive for det F > 0.
Mat2 rotationOf(const Mat2& F) {
    const double c = F(0, 0) + F(1, 1), s = F(1, 0) - F(0, 1), n = std::hypot(c, s);
    Mat2 R;
    R << c / n, -s / n, s / n, c / n;
    return R;
}

/// Returns the limit of Newton's iteration X ← ½ (γX + (γX)⁻ᵀ), X₀ = F, with Higham's scaling γ² = ‖X⁻¹‖ /
/// ‖X‖ in the Frobenius norm (Higham 1986). The convergence is quadratic and takes about 6 steps; without γ
/// the first steps would only halve the distance of a strongly stretched map. The bound on the steps ends NaN
/// and singular maps.
Mat3 rotationOf(const Mat3& F) {
    Mat3 X = F;
    for (int i = 0; i < 30; ++i) {
        const Mat3 inverse = X.inverse().transpose();
        const double scale = std::sqrt(inverse.norm() / X.norm());
        const Mat3 next = 0.5 * (scale * X + inverse / scale);
        const double change = (next - X).norm();
        X = next;
        if (!(change > 1e-14)) break;
    }
    return X;
}

}  // namespace

template <int Dim>
Mat<Dim> polarRotation(const Mat<Dim>& F) {
    return rotationOf(F);
}

#define WEND_INSTANTIATE(Dim)                                                                             \
    template Mat<Dim> edgeMatrix<Dim>(const Points<Dim>&, const Cell<Dim>&);                              \
    template CellGeometry<Dim> cellGeometry<Dim>(const Points<Dim>&, const Cell<Dim>&);                   \
    template double energyDensity<Dim>(EnergyWeights, const Mat<Dim>&, const Mat<Dim>&);                  \
    template Mat<Dim> stress<Dim>(EnergyWeights, const Mat<Dim>&, const Mat<Dim>&);                       \
    template StressMatrix<Dim> stressMatrix<Dim>(EnergyWeights, const Mat<Dim>&);                         \
    template Mat<Dim> stressBlock<Dim>(EnergyWeights, const Mat<Dim>&, const Vec<Dim>&, const Vec<Dim>&); \
    template Mat<Dim> polarRotation<Dim>(const Mat<Dim>&);
WEND_INSTANTIATE(2)
WEND_INSTANTIATE(3)

}  // namespace wend
