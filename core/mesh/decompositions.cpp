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

template <int Columns, int Sides>
LeastSquares<Columns, Sides> leastSquares(const Eigen::Matrix<double, Eigen::Dynamic, Columns>& A,
                                          const Eigen::Matrix<double, Eigen::Dynamic, Sides>& B,
                                          double tolerance) {
    Eigen::ColPivHouseholderQR<Eigen::Matrix<double, Eigen::Dynamic, Columns>> solver(A);
    solver.setThreshold(tolerance);
    return {solver.solve(B), static_cast<int>(solver.rank())};
}

#define WEND_INSTANTIATE(Dim)                                                      \
    template SingularValues<Dim> singularValueDecomposition<Dim>(const Mat<Dim>&); \
    template Vec<Dim> singularValues<Dim>(const Mat<Dim>&);                        \
    template PrincipalAxes<Dim> principalAxes<Dim>(const Mat<Dim>&);               \
    template Vec<Dim> symmetricEigenvalues<Dim>(const Mat<Dim>&);                  \
    template LeastSquares<Dim, Dim> leastSquares<Dim, Dim>(                        \
        const Eigen::Matrix<double, Eigen::Dynamic, Dim>&,                         \
        const Eigen::Matrix<double, Eigen::Dynamic, Dim>&, double);
WEND_INSTANTIATE(2)
WEND_INSTANTIATE(3)

template LeastSquares<2, 3> leastSquares<2, 3>(const Eigen::MatrixX2d&, const Eigen::MatrixX3d&, double);
template LeastSquares<3, 2> leastSquares<3, 2>(const Eigen::MatrixX3d&, const Eigen::MatrixX2d&, double);

}  // namespace wend
