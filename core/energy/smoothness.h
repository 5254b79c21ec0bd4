#pragma once

#include "core/energy/material.h"
#include "core/mesh/simplicial_mesh.h"

namespace wend {

/// Length (2D) or area (3D) of a facet.
template <int Dim>
double facetMeasure(const Points<Dim>& points, const std::array<int, Dim>& facet);

/// The weight of ‖P_j − P_i‖²_F over the interior facet between the cells i and j (method.md, Smoothness):
/// (s²/16) B_ij / h_ij, λ B_ij (paper, Eq. 13) or 0, with B_ij the measure of the facet and h_ij the distance
/// of the centroids. `points` are in the frame where the rest diagonal is 1.
template <int Dim>
double smoothnessWeight(const Smoothing& smoothing, const Points<Dim>& points,
                        const std::array<int, Dim>& facet, const Cell<Dim>& i, const Cell<Dim>& j);

}  // namespace wend
