#include "core/mesh/decompositions.h"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <Eigen/SVD>

namespace wend {

template <int Dim>
SingularValues<Dim> singularValueDecomposition(const Mat<Dim>& A) {
    const Eigen::JacobiSVD<Mat<Dim>> svd(A, Eigen::ComputeFullU | Eigen::ComputeFullV);
    return {svd.matrixU(), svd.matrixV(), svd.singularValues()};
}

template <int Dim>
Vec<Dim> singularValues(const Mat<Dim>& A) {
    return Eigen::JacobiSVD<Mat<Dim>>(A).singularValues();
}

template <int Dim>
PrincipalAxes<Dim> principalAxes(const Mat<Dim>& A) {
    const Eigen::SelfAdjointEigenSolver<Mat<Dim>> solver(A);
    return {solver.eigenvectors(), solver.eigenvalues()};
}

template <int Dim>
Vec<Dim> symmetricEigenvalues(const Mat<Dim>& A) {
    return Eigen::SelfAdjointEigenSolver<Mat<Dim>>(A, Eigen::EigenvaluesOnly).eigenvalues();
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

namespace {

Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> decomposed(const Eigen::MatrixXd& A,
                                                                   double tolerance) {
    Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> result;
    result.setThreshold(tolerance);
    result.compute(A);
    return result;
}

}  // namespace

Eigen::MatrixXd pseudoInverse(const Eigen::MatrixXd& A, double tolerance) {
    return decomposed(A, tolerance).solve(Eigen::MatrixXd::Identity(A.rows(), A.rows()).eval());
}

Eigen::VectorXd leastNormSolution(const Eigen::MatrixXd& A, const Eigen::VectorXd& b, double tolerance) {
    return decomposed(A, tolerance).solve(Eigen::MatrixXd(b));
}

LeastSquares<Eigen::Dynamic, Eigen::Dynamic> leastSquares(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B,
                                                          double tolerance) {
    Eigen::ColPivHouseholderQR<Eigen::MatrixXd> solver(A);
    solver.setThreshold(tolerance);
    return {solver.solve(B), static_cast<int>(solver.rank())};
}

#define WEND_INSTANTIATE(Dim)                                                      \
    template SingularValues<Dim> singularValueDecomposition<Dim>(const Mat<Dim>&); \
    template Vec<Dim> singularValues<Dim>(const Mat<Dim>&);                        \
    template PrincipalAxes<Dim> principalAxes<Dim>(const Mat<Dim>&);               \
    template Vec<Dim> symmetricEigenvalues<Dim>(const Mat<Dim>&);
WEND_INSTANTIATE(2)
WEND_INSTANTIATE(3)

}  // namespace wend
