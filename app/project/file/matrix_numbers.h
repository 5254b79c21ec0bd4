#pragma once

#include <vector>

#include "core/base/types.h"

namespace wend {

/// The numbers of a symmetric matrix, each once.
template <int Dim>
inline constexpr std::size_t kSymmetricNumbers = Dim*(Dim + 1) / 2;

/// Returns the matrix of Dim² numbers, row by row; or of kSymmetricNumbers in the order of VTK: xx, yy, xy in
/// the plane, xx, yy, zz, xy, yz, xz in space.
template <int Dim>
Mat<Dim> matrixFrom(const std::vector<double>& numbers) {
    if (numbers.size() == Dim * Dim)
        return Eigen::Map<const Eigen::Matrix<double, Dim, Dim, Eigen::RowMajor>>(numbers.data());
    Mat<Dim> matrix;
    for (int k = 0; k < Dim; ++k) matrix(k, k) = numbers[static_cast<std::size_t>(k)];
    const auto set = [&](int i, int j, int place) {
        matrix(i, j) = matrix(j, i) = numbers[static_cast<std::size_t>(place)];
    };
    set(0, 1, Dim);
    if constexpr (Dim == 3) set(1, 2, 4), set(0, 2, 5);
    return matrix;
}

}  // namespace wend
