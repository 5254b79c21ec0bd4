#pragma once

#include <memory>

#include "core/mesh/types.h"

namespace wend {

// Eigen's decompositions of matrices of any size, compiled once: a file that instantiates one of them takes
// five to twenty seconds more to compile.

/// The pseudoinverse A⁺; singular values up to `least` count as 0.
Eigen::MatrixXd pseudoInverse(const Eigen::MatrixXd& A, double least);

/// The shortest of all x of least |A x − b|, by a complete orthogonal decomposition. Directions of A that are
/// weaker than the tolerance, relatively, do not count.
Eigen::VectorXd leastNormSolution(const Eigen::MatrixXd& A, const Eigen::VectorXd& b, double tolerance);

/// A = Q diag(λ) Qᵀ of a symmetric matrix; λ ascending. Reads the lower triangle.
struct EigenPairs {
    Eigen::MatrixXd vectors;
    Eigen::VectorXd values;
};
EigenPairs eigenPairs(const Eigen::MatrixXd& A);

/// The largest eigenvalue of a symmetric tridiagonal matrix.
double largestEigenvalue(const Eigen::VectorXd& diagonal, const Eigen::VectorXd& side);

/// Wᵀ (W Wᵀ)⁻¹ of a matrix of independent rows. Cheap to copy.
class RightInverse {
  public:
    explicit RightInverse(const Eigen::MatrixXd& W);
    Eigen::MatrixXd times(const Eigen::MatrixXd& right) const;

  private:
    struct Factor;
    std::shared_ptr<const Factor> m_factor;
};

}  // namespace wend
