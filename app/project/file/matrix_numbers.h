#pragma once

#include <vector>

#include "core/base/types.h"

namespace wend {

/// Returns how many numbers a symmetric matrix has, each counted once.
constexpr std::size_t symmetricNumbers(int dimension) {
    return static_cast<std::size_t>(dimension * (dimension + 1) / 2);
}

/// Returns the matrix of d² numbers, row by row; or of symmetricNumbers(d) in the order of VTK: xx, yy, xy in
/// the plane, xx, yy, zz, xy, yz, xz in space. In the plane it leaves z as it is.
inline Mat3 matrixFrom(const std::vector<double>& numbers, int dimension) {
    Mat3 matrix = Mat3::Identity();
    const auto at = [&](int place) { return numbers[static_cast<std::size_t>(place)]; };
    if (numbers.size() == static_cast<std::size_t>(dimension * dimension)) {
        for (int i = 0; i < dimension; ++i)
            for (int j = 0; j < dimension; ++j) matrix(i, j) = at(i * dimension + j);
        return matrix;
    }
    for (int k = 0; k < dimension; ++k) matrix(k, k) = at(k);
    matrix(0, 1) = matrix(1, 0) = at(dimension);
    if (dimension == 2) return matrix;
    matrix(1, 2) = matrix(2, 1) = at(4);
    matrix(0, 2) = matrix(2, 0) = at(5);
    return matrix;
}

}  // namespace wend
