#pragma once

#include "core/base/types.h"

namespace wend {

// Eigen's decompositions are compiled once, because a file that instantiates one of them takes seconds more
// to compile; those of matrices of any size, which take five to twenty, serve more than small ones.

/// A = U diag(σ) Vᵀ with orthogonal U and V; σ descending.
template <int Dim>
struct SingularValues {
    Mat<Dim> U, V;
    Vec<Dim> sigma;
};

/// Computes the decomposition by Jacobi rotations, which are backward stable. U and V may be reflections;
/// columns of singular values that are equal are arbitrary. NaN in A gives NaN.
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

/// A = Q diag(λ) Qᵀ of a symmetric matrix of any size; λ ascending.
struct EigenPairs {
    Eigen::MatrixXd vectors;
    Eigen::VectorXd values;
};
/// Computes the decomposition by QR iterations; reads the lower triangle.
EigenPairs eigenPairs(const Eigen::MatrixXd& A);

/// Returns the largest eigenvalue of a symmetric tridiagonal matrix. `side` is one shorter than `diagonal`,
/// which must not be empty.
double largestEigenvalue(const Eigen::VectorXd& diagonal, const Eigen::VectorXd& side);

/// Returns the pseudoinverse A⁺ by a complete orthogonal decomposition. Directions of A that are weaker than
/// the relative tolerance count as 0. It has as many rows as A has columns. The tolerance is relative to the
/// largest pivot.
Eigen::MatrixXd pseudoInverse(const Eigen::MatrixXd& A, double tolerance);

/// Returns the shortest of all x of least |A x − b|, in the same manner.
Eigen::VectorXd leastNormSolution(const Eigen::MatrixXd& A, const Eigen::VectorXd& b, double tolerance);

/// The X of least |A X − B|, with the rank of A.
template <int Columns, int Sides>
struct LeastSquares {
    Eigen::Matrix<double, Columns, Sides> X;
    int rank;
};

/// Solves by Householder's QR decomposition with column pivoting. Pivots up to `tolerance`, relative to the
/// largest, do not count in the rank; X does not depend on it.
LeastSquares<Eigen::Dynamic, Eigen::Dynamic> leastSquares(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B,
                                                          double tolerance = 0);
/// Does the same for sizes that are known.
template <int Columns, int Sides>
LeastSquares<Columns, Sides> leastSquares(const Eigen::Matrix<double, Eigen::Dynamic, Columns>& A,
                                          const Eigen::Matrix<double, Eigen::Dynamic, Sides>& B,
                                          double tolerance = 0) {
    const auto solved = leastSquares(Eigen::MatrixXd(A), Eigen::MatrixXd(B), tolerance);
    return {solved.X, solved.rank};
}

}  // namespace wend
