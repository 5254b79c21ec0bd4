#pragma once

#include <Eigen/LU>

#include "core/base/types.h"

namespace wend {

/// Returns the barycentric coordinates of p, which may be outside of the cell: [x1 − x0, …] (w1, …)ᵀ = p − x0
/// and w0 = 1 − Σ, by Cramer's rule. They are not finite for a flat cell.
template <int Dim>
Eigen::Matrix<double, Dim + 1, 1> barycentric(const Points<Dim>& points, const Cell<Dim>& cell,
                                              const Vec<Dim>& p) {
    Mat<Dim> edges;
    for (int k = 0; k < Dim; ++k) edges.col(k) = points.col(cell[k + 1]) - points.col(cell[0]);
    const double det = edges.determinant();
    const Vec<Dim> offset = p - points.col(cell[0]);
    Eigen::Matrix<double, Dim + 1, 1> weights;
    for (int k = 0; k < Dim; ++k) {
        Mat<Dim> replaced = edges;
        replaced.col(k) = offset;
        weights[k + 1] = replaced.determinant() / det;
    }
    weights[0] = 1 - weights.template tail<Dim>().sum();
    return weights;
}

/// Returns the mean of the cell's corners.
template <int Dim>
Vec<Dim> centroid(const Points<Dim>& points, const Cell<Dim>& cell) {
    Vec<Dim> sum = Vec<Dim>::Zero();
    for (int vertex : cell) sum += points.col(vertex);
    return sum / (Dim + 1);
}

}  // namespace wend
