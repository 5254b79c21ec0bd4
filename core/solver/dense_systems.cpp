#include "core/solver/dense_systems.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <Eigen/SVD>

namespace wend {

Eigen::MatrixXd pseudoInverse(const Eigen::MatrixXd& A, double least) {
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(A, Eigen::ComputeThinU | Eigen::ComputeThinV);
    Eigen::MatrixXd inverse = Eigen::MatrixXd::Zero(A.cols(), A.rows());
    for (Eigen::Index i = 0; i < svd.singularValues().size(); ++i)
        if (const double value = svd.singularValues()[i]; value > least)
            inverse += svd.matrixV().col(i) * svd.matrixU().col(i).transpose() / value;
    return inverse;
}

Eigen::VectorXd leastNormSolution(const Eigen::MatrixXd& A, const Eigen::VectorXd& b, double tolerance) {
    Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> fit;
    fit.setThreshold(tolerance);
    fit.compute(A);
    return fit.solve(b);
}

EigenPairs eigenPairs(const Eigen::MatrixXd& A) {
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(A);
    return {solver.eigenvectors(), solver.eigenvalues()};
}

double largestEigenvalue(const Eigen::VectorXd& diagonal, const Eigen::VectorXd& side) {
    Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver;
    solver.computeFromTridiagonal(diagonal, side, Eigen::EigenvaluesOnly);
    return solver.eigenvalues().maxCoeff();
}

struct RightInverse::Factor {
    Eigen::MatrixXd W;
    Eigen::LDLT<Eigen::MatrixXd> WWt;
};

RightInverse::RightInverse(const Eigen::MatrixXd& W)
    : m_factor(std::make_shared<const Factor>(Factor{W, Eigen::LDLT<Eigen::MatrixXd>(W * W.transpose())})) {}

Eigen::MatrixXd RightInverse::times(const Eigen::MatrixXd& right) const {
    return m_factor->W.transpose() * m_factor->WWt.solve(right);
}

}  // namespace wend
