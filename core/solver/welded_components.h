#pragma once

#include <array>
#include <vector>

#include "core/base/types.h"

namespace wend {

/// The velocities at a point of the similarities' modes, a column each: a translation along every axis, a
/// rotation in every plane, and a scaling.
template <int Dim>
using SimilarityVelocities = Eigen::Matrix<double, Dim, Dim + Dim*(Dim - 1) / 2 + 1>;
/// Returns these velocities at p. Rotations are in the planes (a, b), a < b, in this order, with the velocity
/// −p_b along a and p_a along b.
template <int Dim>
SimilarityVelocities<Dim> similarityVelocities(const Vec<Dim>& p);

/// MᵀM, where the rows of M are coordinates of similarityVelocities() at places that are held.
template <int Dim>
using SimilaritySquare = Mat<SimilarityVelocities<Dim>::ColsAtCompileTime>;

/// A point that two components share, relative to the middle of the shape, in terms of its size.
template <int Dim>
struct WeldedPoint {
    std::array<int, 2> components;
    Vec<Dim> place;
};

/// Sets `held` for components that have no similarity left. S is the quadratic form of the components'
/// similarities that sums up `squares` and |M(p) (a − b)|² over the welded points, at which both components
/// must move alike; a component is free if it takes part in an eigenvector of S to an eigenvalue of at most
/// distinct². Considers only components that welds connect.
template <int Dim>
void holdWelded(const std::vector<SimilaritySquare<Dim>>& squares,
                const std::vector<WeldedPoint<Dim>>& welded, double distinct, std::vector<bool>& held);

}  // namespace wend
