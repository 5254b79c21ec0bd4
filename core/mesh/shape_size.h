#pragma once

#include <vector>

#include "core/mesh/types.h"

namespace wend {

/// Where a shape is and how large: the centroid, and √(12 Tr C) with C the covariance of the domain, that is,
/// its second central moments over its area or volume. Of a box that is the diagonal; it is the same in every
/// orientation, whatever the cells. The unit of every dimensionless setting (docs/method.md, (9)).
template <int Dim>
struct ShapeSize {
    Vec<Dim> centroid = Vec<Dim>::Zero();
    double size = 0;
};

/// Of the union of cells, exactly: ∫|x − m|² over a simplex of measure V with corners x_k and centroid c is
/// V (|c − m|² + Σ_k |x_k − c|² / ((d + 1)(d + 2))). Vertices that no cell has do not count.
template <int Dim>
ShapeSize<Dim> shapeSize(const Points<Dim>& points, const std::vector<Cell<Dim>>& cells);

}  // namespace wend
