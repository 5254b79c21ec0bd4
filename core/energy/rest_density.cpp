#include "core/energy/rest_density.h"

#include <Eigen/LU>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/mesh/decompositions.h"

namespace wend {
namespace {

// A strain that is less is rounding: a shape that has only moved feels no force.
constexpr double kNoStrain = 1e-12;

template <int Dim>
bool isIdentity(const Mat<Dim>& B) {
    return B == Mat<Dim>::Identity();
}

/// Returns C − I entry by entry (g++ 12 warns of the products of small matrices otherwise).
template <int Dim>
Mat<Dim> twiceGreenStrain(const Mat<Dim>& F) {
    Mat<Dim> E = F.transpose().lazyProduct(F);
    E.diagonal().array() -= 1;
    return E;
}

/// F = U diag(σ) Vᵀ with orthogonal U and V, both rotations or both reflections, for det F > 0.
template <int Dim>
struct Stretch {
    Mat<Dim> U, V;
    Vec<Dim> sigma;
};

/// Computes the singular values from half the sum and half the difference of the angles of the conformal and
/// the anticonformal part of F.
Stretch<2> stretchOf(const Mat2& F) {
    const double even = 0.5 * (F(0, 0) + F(1, 1)), turn = 0.5 * (F(1, 0) - F(0, 1)),
                 odd = 0.5 * (F(0, 0) - F(1, 1)), shear = 0.5 * (F(1, 0) + F(0, 1));
    const double kept = std::hypot(even, turn), lost = std::hypot(odd, shear);
    const double a = std::atan2(turn, even), b = lost > 0 ? std::atan2(shear, odd) : a;
    const auto rotation = [](double angle) {
        return Mat2{{std::cos(angle), -std::sin(angle)}, {std::sin(angle), std::cos(angle)}};
    };
    return {rotation(0.5 * (b + a)), rotation(0.5 * (b - a)), {kept + lost, kept - lost}};
}

Stretch<3> stretchOf(const Mat3& F) {
    const auto svd = singularValueDecomposition<3>(F);
    return {svd.U, svd.V, svd.sigma};
}

template <int Dim>
using Modes = Eigen::Matrix<double, Dim * Dim, Dim * Dim>;

/// Returns J^(−2/d).
template <int Dim>
double shrink(double J) {
    if constexpr (Dim == 2) return 1 / J;
    return 1 / std::cbrt(J * J);
}

template <int Dim>
auto flat(const Mat<Dim>& M) {
    return Eigen::Map<const Eigen::Matrix<double, Dim * Dim, 1>>(M.data());
}

/// The numbers a, b and c of restHessian() for J and s = ‖F‖².
struct IsotropicTerms {
    double a, b, c;
};
template <int Dim>
IsotropicTerms isotropicTerms(EnergyWeights w, double J, double squares) {
    const double k = 4 * w.q / Dim + w.r, a = 4 * w.q * shrink<Dim>(J);
    return {a, k * (J - 1 / J) - a * squares / Dim, k * (J + 1 / J) + 2 * a * squares / (Dim * Dim)};
}

/// Computes the modes with ∂ψ/∂σ_i = a σ_i + b/σ_i.
template <int Dim>
RestModes<Dim> isotropicModes(EnergyWeights w, const Mat<Dim>& F) {
    const auto [U, V, sigma] = stretchOf(F);
    const auto [a, b, c] = isotropicTerms<Dim>(w, sigma.prod(), sigma.squaredNorm());
    Mat<Dim> bySigma;  // ∂²ψ/∂σ²
    for (int i = 0; i < Dim; ++i)
        for (int j = 0; j < Dim; ++j)
            bySigma(i, j) = (i == j ? a - b / (sigma[i] * sigma[i]) : 0) + c / (sigma[i] * sigma[j]) -
                            2 * a / Dim * (sigma[i] / sigma[j] + sigma[j] / sigma[i]);
    const PrincipalAxes<Dim> stretches = principalAxes<Dim>(bySigma);
    RestModes<Dim> result;
    int m = 0;
    const auto add = [&](double value, const Mat<Dim>& inner) {
        const Mat<Dim> mode = U * inner * V.transpose();
        result.values[m] = value;
        result.modes.col(m++) = flat<Dim>(mode);
    };
    for (int i = 0; i < Dim; ++i) add(stretches.values[i], stretches.axes.col(i).asDiagonal());
    for (int i = 0; i < Dim; ++i)
        for (int j = i + 1; j < Dim; ++j)
            for (const double sign : {-1.0, 1.0}) {  // a twist, a flip
                Mat<Dim> inner = Mat<Dim>::Zero();
                inner(i, j) = 1 / std::numbers::sqrt2;
                inner(j, i) = sign / std::numbers::sqrt2;
                add(a - sign * b / (sigma[i] * sigma[j]), inner);
            }
    return result;
}

/// Computes the derivative of restStress() in every direction e_a e_bᵀ, for B₀ ≠ I. With w = w_C(C) + w_J(J),
/// E = C − I and dE = DᵀF + FᵀD, one column is
///   dP = 2 D ∂w_C/∂C + 2 F (∂²w_C/∂C² : dE) + (J w_J′)′ J Tr(F⁻¹D) F⁻ᵀ − J w_J′ (F⁻¹ D F⁻¹)ᵀ,
/// in which `byC` is ∂w_C/∂C, `change` its derivative along dE, `byJ` is J w_J′, and `slope` J (J w_J′)′.
template <int Dim>
Modes<Dim> anisotropicHessian(EnergyWeights w, const Mat<Dim>& B0, const Mat<Dim>& F) {
    const Mat<Dim> E = twiceGreenStrain<Dim>(F), BE = B0 * E, inverse = F.inverse();
    const double J = F.determinant(), trace = B0.trace(), r = 0.5 * w.r * (Dim / trace),
                 q = w.q * (trace / Dim), cube = std::pow(J - 1, 3);
    const Mat<Dim> byC = w.q * (BE + Mat<Dim>(BE.transpose())) + r * BE.trace() * B0;
    const double byJ = q * cube * (3 * J + 1) / J,
                 slope = q * (3 * (J - 1) * (J - 1) * (3 * J + 1) - cube / J);  // J ∂byJ/∂J
    Modes<Dim> H;
    for (int column = 0; column < Dim * Dim; ++column) {
        Mat<Dim> D = Mat<Dim>::Zero();
        D(column % Dim, column / Dim) = 1;
        const Mat<Dim> half = D.transpose() * F, dE = half + half.transpose(), BdE = B0 * dE;
        const Mat<Dim> change = w.q * (BdE + Mat<Dim>(BdE.transpose())) + r * BdE.trace() * B0;
        const Mat<Dim> turned = inverse * D * inverse;
        const Mat<Dim> dP = 2 * D * byC + 2 * F * change +
                            slope * (inverse * D).trace() * Mat<Dim>(inverse.transpose()) -
                            byJ * Mat<Dim>(turned.transpose());
        H.col(column) = flat<Dim>(dP);
    }
    return H;
}

}  // namespace

/// Evaluates w by the formula for B₀ = I where that applies, since it needs no product with B₀.
template <int Dim>
double restDensity(EnergyWeights w, const Mat<Dim>& B0, const Mat<Dim>& F) {
    const double J = F.determinant();
    if (!(J > 0)) return std::numeric_limits<double>::infinity();
    if (isIdentity<Dim>(B0)) {
        const double angle = F.squaredNorm() * shrink<Dim>(J) - Dim;
        return 2 * w.q * angle + (4 * w.q / Dim + w.r) * (J - 1) * (J - 1) / J;
    }
    const Mat<Dim> E = twiceGreenStrain<Dim>(F), BE = B0 * E;
    const double dilation = 0.5 * BE.trace(), trace = B0.trace();
    return w.q * (E * BE).trace() + w.r * (Dim / trace) * dilation * dilation +
           w.q * (trace / Dim) * std::pow(J - 1, 4) / J;
}

template <int Dim>
Mat<Dim> restStress(EnergyWeights w, const Mat<Dim>& B0, const Mat<Dim>& F) {
    const Mat<Dim> E = twiceGreenStrain<Dim>(F);
    if (E.norm() <= kNoStrain) return Mat<Dim>::Zero();
    const double J = F.determinant();
    const Mat<Dim> inverse = F.inverse().transpose();
    if (isIdentity<Dim>(B0)) {
        const double angle = 4 * w.q * shrink<Dim>(J), volume = (4 * w.q / Dim + w.r) * (J - 1 / J);
        return angle * F + (volume - angle * F.squaredNorm() / Dim) * inverse;
    }
    const Mat<Dim> BE = B0 * E;
    const double trace = B0.trace();
    const Mat<Dim> byC = w.q * (BE + Mat<Dim>(BE.transpose())) + 0.5 * w.r * (Dim / trace) * BE.trace() * B0;
    const double byJ = w.q * (trace / Dim) * std::pow(J - 1, 3) * (3 * J + 1) / J;
    return 2 * F * byC + byJ * inverse;
}

template <int Dim>
RestModes<Dim> restModes(EnergyWeights w, const Mat<Dim>& B0, const Mat<Dim>& F) {
    if (isIdentity<Dim>(B0)) return isotropicModes<Dim>(w, F);
    const EigenPairs pairs = eigenPairs(anisotropicHessian<Dim>(w, B0, F));
    return {pairs.values, pairs.vectors};
}

template <int Dim>
CornerHessian<Dim> restHessian(EnergyWeights w, const Mat<Dim>& B0, const Mat<Dim>& F, const Mat<Dim>& hats) {
    CornerHessian<Dim> H;
    if (!isIdentity<Dim>(B0)) {
        Modes<Dim> onCorners = Modes<Dim>::Zero();  // ∂F/∂x, F column by column
        for (int k = 0; k < Dim; ++k)
            for (int b = 0; b < Dim; ++b)
                for (int i = 0; i < Dim; ++i) onCorners(Dim * b + i, Dim * k + i) = hats(b, k);
        const Modes<Dim> half = onCorners.transpose() * anisotropicHessian<Dim>(w, B0, F) * onCorners;
        H = 0.5 * (half + half.transpose());
        return H;
    }
    const auto [a, b, c] = isotropicTerms<Dim>(w, F.determinant(), F.squaredNorm());
    const Mat<Dim> f = 2 * a / Dim * F * hats, n = F.inverse().transpose() * hats;
    for (int l = 0; l < Dim; ++l)
        for (int m = l; m < Dim; ++m) {
            const double inner = a * hats.col(l).dot(hats.col(m));
            for (int i = 0; i < Dim; ++i)
                for (int j = 0; j < Dim; ++j)
                    H(Dim * l + i, Dim * m + j) = H(Dim * m + j, Dim * l + i) =
                        (i == j ? inner : 0) - (f(i, l) * n(j, m) + n(i, l) * f(j, m)) +
                        c * n(i, l) * n(j, m) - b * n(i, m) * n(j, l);
        }
    return H;
}

#define WEND_INSTANTIATE(Dim)                                                                     \
    template double restDensity<Dim>(EnergyWeights, const Mat<Dim>&, const Mat<Dim>&);            \
    template Mat<Dim> restStress<Dim>(EnergyWeights, const Mat<Dim>&, const Mat<Dim>&);           \
    template RestModes<Dim> restModes<Dim>(EnergyWeights, const Mat<Dim>&, const Mat<Dim>&);      \
    template CornerHessian<Dim> restHessian<Dim>(EnergyWeights, const Mat<Dim>&, const Mat<Dim>&, \
                                                 const Mat<Dim>&);
WEND_INSTANTIATE(2)
WEND_INSTANTIATE(3)

}  // namespace wend
