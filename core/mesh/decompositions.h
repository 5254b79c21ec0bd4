#pragma once

#include "core/base/types.h"

namespace wend {

// Eigen's decompositions of small matrices are compiled once, because a file that instantiates one of them
// takes seconds more to compile.

/// A = U diag(σ) Vᵀ with orthogonal U and V; σ descending.
template <int Dim>
struct SingularValues {
    Mat<Dim> U, V;
    Vec<Dim> sigma;
};

/// Computes the decomposition by Jacobi rotations, which are backward stable.
template <int Dim>
SingularValues<Dim> singularValueDecomposition(const Mat<Dim>& A);
/// Computes σ alone.
template <int Dim>
Vec<Dim> singularValues(const Mat<Dim>& A);

/// A = Q diag(λ) Qᵀ of a symmetric matrix with orthogonal Q; λ ascending.
template <int Dim>
struct PrincipalAxes {
    Mat<Dim> axes;
    Vec<Dim> values;
};

/// Computes the decomposition by QR iterations; reads the lower triangle.
template <int Dim>
PrincipalAxes<Dim> principalAxes(const Mat<Dim>& A);
/// Computes λ alone.
template <int Dim>
Vec<Dim> symmetricEigenvalues(const Mat<Dim>& A);

/// The X of least |A X − B|, with the rank of A.
template <int Columns, int Sides>
struct LeastSquares {
    Eigen::Matrix<double, Columns, Sides> X;
    int rank;
};

/// Solves by Householder's QR decomposition with column pivoting. Pivots up to `tolerance`, relative to the
/// largest, do not count in the rank; X does not depend on it.
template <int Columns, int Sides>
LeastSquares<Columns, Sides> leastSquares(const Eigen::Matrix<double, Eigen::Dynamic, Columns>& A,
                                          const Eigen::Matrix<double, Eigen::Dynamic, Sides>& B,
                                          double tolerance = 0);

}  // namespace wend
