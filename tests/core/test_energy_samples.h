#pragma once

#include <array>
#include <cmath>
#include <random>

#include "core/energy/material.h"
#include "core/mesh/simplicial_mesh.h"
#include "tests/core/test_mesh_samples.h"

namespace wend::test {

/// The unit square or cube in n^Dim boxes, scaled to a bounding-box diagonal of 1, the vertices moved by up
/// to `jitter` of an edge.
template <int Dim>
SimplicialMesh<Dim> unitGrid(int n, double jitter, std::mt19937& random) {
    auto mesh = samples::grid<Dim>(n);
    std::uniform_real_distribution<double> offset(-jitter / n, jitter / n);
    for (auto& x : mesh.points.reshaped()) x += offset(random);
    mesh.points /= boundingBoxDiagonal<Dim>(mesh.points);
    return mesh;
}

inline double uniform(std::mt19937& random, double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
}

template <int Rows, int Cols>
Eigen::Matrix<double, Rows, Cols> randomMatrix(std::mt19937& random, int rows = Rows, int cols = Cols) {
    Eigen::Matrix<double, Rows, Cols> A(rows, cols);
    for (auto& x : A.reshaped()) x = uniform(random, -1, 1);
    return A;
}

template <int Dim>
Points<Dim> randomField(std::mt19937& random, int vertices) {
    return randomMatrix<Dim, Eigen::Dynamic>(random, Dim, vertices);
}

/// A skew matrix: the Jacobian of an infinitesimal rotation.
template <int Dim>
Mat<Dim> randomSkew(std::mt19937& random) {
    const Mat<Dim> A = randomMatrix<Dim, Dim>(random);
    Mat<Dim> W;
    for (int i = 0; i < Dim; ++i)
        for (int j = 0; j < Dim; ++j) W(i, j) = A(i, j) - A(j, i);
    return W;
}

/// Symmetric positive definite with eigenvalues from about 1 to `ratio`.
template <int Dim>
Mat<Dim> randomAnisotropy(std::mt19937& random, double ratio) {
    const Vec<Dim> a = randomMatrix<Dim, 1>(random).normalized(),
                   b = randomMatrix<Dim, 1>(random).normalized();
    return Mat<Dim>::Identity() + (ratio - 1) * a * a.transpose() + 0.3 * b * b.transpose();
}

/// φ and B different in every cell, all over their range.
template <int Dim>
Material<Dim> randomMaterial(std::mt19937& random, int cells, Smoothing smoothing) {
    Material<Dim> material{{}, {}, smoothing};
    for (int c = 0; c < cells; ++c) {
        material.phi.push_back(uniform(random, 0.1, phi::conformal(Dim) - 0.05));
        material.anisotropy.push_back(randomAnisotropy<Dim>(random, 20));
    }
    return material;
}

/// x ↦ J x + t as a nodal field.
template <int Dim>
Points<Dim> affineField(const Points<Dim>& points, const Mat<Dim>& J, const Vec<Dim>& t) {
    Points<Dim> v = J * points;
    v.colwise() += t;
    return v;
}

}  // namespace wend::test
