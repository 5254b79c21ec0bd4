#pragma once

#include <Eigen/Core>
#include <array>

namespace wend {

/// A point or a vector; lengths are in the domain's unit unless a comment says otherwise.
template <int Dim>
using Vec = Eigen::Matrix<double, Dim, 1>;
template <int Dim>
using Mat = Eigen::Matrix<double, Dim, Dim>;

/// The points of a shape, one column per vertex and contiguous, so that a shape, a velocity field or a stage
/// is one flat vector.
template <int Dim>
using Points = Eigen::Matrix<double, Dim, Eigen::Dynamic>;

/// The Dim + 1 vertex indices of a triangle or tetrahedron.
template <int Dim>
using Cell = std::array<int, Dim + 1>;

}  // namespace wend
