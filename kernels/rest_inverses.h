#pragma once

#include <Eigen/LU>
#include <vector>

#include "core/mesh/simplicial_mesh.h"

namespace wend {

/// Returns E₀⁻¹ of every cell, with the rest edges as the rows of E₀, row by row.
template <int Dim>
std::vector<double> restInverses(const SimplicialMesh<Dim>& rest) {
    std::vector<double> values;
    for (const auto& cell : rest.cells) {
        Mat<Dim> edges;
        for (int k = 0; k < Dim; ++k)
            edges.row(k) = (rest.points.col(cell[k + 1]) - rest.points.col(cell[0])).transpose();
        const Mat<Dim> inverse = edges.inverse();
        for (int a = 0; a < Dim; ++a)
            for (int b = 0; b < Dim; ++b) values.push_back(inverse(a, b));
    }
    return values;
}

}  // namespace wend
