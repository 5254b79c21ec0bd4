#pragma once

#include <cmath>
#include <vector>

#include "core/mesh/cell_geometry.h"

namespace wend {

/// Returns vertex values of piecewise constant cell values: the mean over the adjacent cells weighted by rest
/// area or volume, x_v = Σ |c| x_c / Σ |c| over the cells c of vertex v, and `zero` for unused vertices.
template <int Dim, class Value>
std::vector<Value> vertexMeans(const SimplicialMesh<Dim>& rest, const std::vector<Value>& ofCells,
                               const Value& zero) {
    std::vector<Value> means(static_cast<std::size_t>(rest.vertexCount()), zero);
    std::vector<double> weights(means.size(), 0);
    for (std::size_t c = 0; c < rest.cells.size(); ++c) {
        const double weight = std::abs(cellMeasure<Dim>(rest.points, rest.cells[c]));
        for (const int v : rest.cells[c]) {
            means[v] += weight * ofCells[c];
            weights[v] += weight;
        }
    }
    for (std::size_t v = 0; v < means.size(); ++v)
        if (weights[v] > 0) means[v] /= weights[v];
    return means;
}

}  // namespace wend
