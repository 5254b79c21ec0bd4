#pragma once

#include <memory>

#include "core/base/types.h"

namespace wend {

// Eigen's decompositions of matrices of any size are compiled once, because a file that instantiates one of
// them takes five to twenty seconds more to compile.

/// Returns the pseudoinverse A⁺; singular values up to `least` count as 0.
Eigen::MatrixXd pseudoInverse(const Eigen::MatrixXd& A, double least);

/// Returns the shortest of all x of least |A x − b|, by a complete orthogonal decomposition. Directions of A
/// that are weaker than the relative tolerance do not count.
Eigen::VectorXd leastNormSolution(const Eigen::MatrixXd& A, const Eigen::VectorXd& b, double tolerance);

/// A = Q diag(λ) Qᵀ of a symmetric matrix; λ ascending. Reads the lower triangle.
struct EigenPairs {
    Eigen::MatrixXd vectors;
    Eigen::VectorXd values;
};
/// Computes the decomposition by QR iterations.
EigenPairs eigenPairs(const Eigen::MatrixXd& A);

/// Returns the largest eigenvalue of a symmetric tridiagonal matrix.
double largestEigenvalue(const Eigen::VectorXd& diagonal, const Eigen::VectorXd& side);

/// Applies Wᵀ (W Wᵀ)⁻¹ of a matrix W of independent rows. It is cheap to copy.
class RightInverse {
  public:
    explicit RightInverse(const Eigen::MatrixXd& W);
    /// Returns Wᵀ (W Wᵀ)⁻¹ times a matrix.
    Eigen::MatrixXd times(const Eigen::MatrixXd& right) const;

  private:
    struct Factor;
    std::shared_ptr<const Factor> m_factor;
};

}  // namespace wend
