#pragma once

#include <vector>

#include "core/mesh/types.h"

namespace wend {

/// Files may hold vertices that no cell has: spare copies of a corner, leftovers of an editor. They belong to
/// no shape; nothing holds on to them and they stretch no bounding box.
template <int Dim>
std::vector<bool> usedVertices(Eigen::Index vertexCount, const std::vector<Cell<Dim>>& cells);

/// An axis-aligned box.
template <int Dim>
struct Extent {
    Vec<Dim> low = Vec<Dim>::Zero(), high = Vec<Dim>::Zero();

    Vec<Dim> centre() const { return (low + high) / 2; }
    double diagonal() const { return (high - low).norm(); }
};

/// The box around the vertices that cells have; a point at the origin without cells.
template <int Dim>
Extent<Dim> extentOf(const Points<Dim>& points, const std::vector<Cell<Dim>>& cells);

}  // namespace wend
