#include "core/energy/rest_density.h"

#include <Eigen/LU>
#include <cmath>
#include <limits>

namespace wend {
namespace {

// A strain that is less is rounding: a shape that has only moved feels no force.
constexpr double kNoStrain = 1e-12;

template <int Dim>
bool isIdentity(const Mat<Dim>& B) {
    return B == Mat<Dim>::Identity();
}

/// C − I, entry by entry (g++ 12 warns of the products of small matrices otherwise).
template <int Dim>
Mat<Dim> twiceGreenStrain(const Mat<Dim>& F) {
    Mat<Dim> E = F.transpose().lazyProduct(F);
    E.diagonal().array() -= 1;
    return E;
}

}  // namespace

template <int Dim>
double restDensity(EnergyWeights w, const Mat<Dim>& B0, const Mat<Dim>& F) {
    const double J = F.determinant();
    if (!(J > 0)) return std::numeric_limits<double>::infinity();
    if (isIdentity<Dim>(B0)) {
        const double angle = F.squaredNorm() * std::pow(J, -2.0 / Dim) - Dim;
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
        const double angle = 4 * w.q * std::pow(J, -2.0 / Dim), volume = (4 * w.q / Dim + w.r) * (J - 1 / J);
        return angle * F + (volume - angle * F.squaredNorm() / Dim) * inverse;
    }
    const Mat<Dim> BE = B0 * E;
    const double trace = B0.trace();
    const Mat<Dim> byC = w.q * (BE + Mat<Dim>(BE.transpose())) + 0.5 * w.r * (Dim / trace) * BE.trace() * B0;
    const double byJ = w.q * (trace / Dim) * std::pow(J - 1, 3) * (3 * J + 1) / J;
    return 2 * F * byC + byJ * inverse;
}

#define WEND_INSTANTIATE(Dim)                                                          \
    template double restDensity<Dim>(EnergyWeights, const Mat<Dim>&, const Mat<Dim>&); \
    template Mat<Dim> restStress<Dim>(EnergyWeights, const Mat<Dim>&, const Mat<Dim>&);
WEND_INSTANTIATE(2)
WEND_INSTANTIATE(3)

}  // namespace wend
