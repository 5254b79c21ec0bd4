#pragma once

#include <vector>

#include "core/base/types.h"

namespace wend {

/// The place and size of a shape: the centroid, and √(12 Tr C) with the covariance C of the domain, that is,
/// its second central moments divided by its measure. For a box this is the diagonal; it is independent of
/// orientation and cells. It is the unit of every dimensionless setting (docs/method.md, (9)).
template <int Dim>
struct ShapeSize {
    Vec<Dim> centroid = Vec<Dim>::Zero();
    double size = 0;
};

/// Computes them exactly for a union of cells: ∫|x − m|² over a simplex of measure V with corners x_k and
/// centroid c is V (|c − m|² + Σ_k |x_k − c|² / ((d + 1)(d + 2))). Unused vertices do not count. The
/// orientation of cells does not matter. Without cells all is 0.
template <int Dim>
ShapeSize<Dim> shapeSize(const Points<Dim>& points, const std::vector<Cell<Dim>>& cells);

}  // namespace wend
