#pragma once

#include <numbers>

#include "core/base/types.h"

namespace wend {

/// The number of entries of a symmetric d × d tensor as a vector in Mandel notation: first the diagonal, then
/// the off-diagonal entries times √2, so that the dot product of two vectors is the Frobenius product of the
/// tensors.
template <int Dim>
inline constexpr int kStrainCount = Dim*(Dim + 1) / 2;
template <int Dim>
using Strain = Eigen::Matrix<double, kStrainCount<Dim>, 1>;
/// A symmetric linear map of symmetric tensors, strain → stress.
template <int Dim>
using StressMatrix = Eigen::Matrix<double, kStrainCount<Dim>, kStrainCount<Dim>>;
/// The strain operator of one corner of a cell. It maps the velocity of the corner to its part of the strain.
template <int Dim>
using StrainColumns = Eigen::Matrix<double, kStrainCount<Dim>, Dim>;

/// Calls visit(index, a, b) for every off-diagonal entry a < b, in the order of the vector.
template <int Dim, typename Visit>
constexpr void forOffDiagonal(Visit&& visit) {
    for (int a = 0, at = Dim; a < Dim; ++a)
        for (int b = a + 1; b < Dim; ++b) visit(at++, a, b);
}

/// Returns a symmetric tensor as a vector.
template <int Dim>
inline Strain<Dim> toMandel(const Mat<Dim>& S) {
    Strain<Dim> s;
    for (int a = 0; a < Dim; ++a) s[a] = S(a, a);
    forOffDiagonal<Dim>([&](int i, int a, int b) { s[i] = std::numbers::sqrt2 * S(a, b); });
    return s;
}

/// Returns the symmetric tensor that a vector represents.
template <int Dim>
inline Mat<Dim> fromMandel(const Strain<Dim>& s) {
    Mat<Dim> S;
    for (int a = 0; a < Dim; ++a) S(a, a) = s[a];
    forOffDiagonal<Dim>([&](int i, int a, int b) { S(a, b) = S(b, a) = s[i] / std::numbers::sqrt2; });
    return S;
}

/// Returns the columns of v ↦ S = v gᵀ + g vᵀ for a hat gradient g, so that the strain of a cell is Σ_k
/// strainColumns(g_k) v_k.
template <int Dim>
inline StrainColumns<Dim> strainColumns(const Vec<Dim>& g) {
    StrainColumns<Dim> columns = StrainColumns<Dim>::Zero();
    for (int a = 0; a < Dim; ++a) columns(a, a) = 2 * g[a];
    forOffDiagonal<Dim>([&](int i, int a, int b) {
        columns(i, a) = std::numbers::sqrt2 * g[b];
        columns(i, b) = std::numbers::sqrt2 * g[a];
    });
    return columns;
}

}  // namespace wend
