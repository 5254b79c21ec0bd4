#pragma once

#include <algorithm>

#include "core/energy/cell_energy.h"
#include "core/energy/material.h"
#include "core/mesh/simplicial_mesh.h"

namespace wend {

/// Returns the length (2D) or area (3D) of a facet, never negative; 0 for a facet whose vertices coincide or,
/// in space, are on a line. `facet` names columns of `points` (Dim × n).
template <int Dim>
double facetMeasure(const Points<Dim>& points, const std::array<int, Dim>& facet);

/// Returns the weight of the jump over the interior facet between the cells i and j (docs/method.md,
/// (10)–(12)): s² B_ij / h_ij of q(J_j − J_i), λ B_ij of ‖P_j − P_i‖²_F, or 0, with B_ij the measure of the
/// facet and h_ij the distance of the centroids. `points` are in the frame where the rest shape has size 1.
/// It is taken at the shape of `points`, not at rest. The first kind is infinite where both centroids
/// coincide, which valid cells on the two sides of a facet exclude.
template <int Dim>
double smoothnessWeight(const Smoothing& smoothing, const Points<Dim>& points,
                        const std::array<int, Dim>& facet, const Cell<Dim>& i, const Cell<Dim>& j);

/// Returns the weights of q between two cells: their means, without the part that would oppose a jump of
/// dilation. q(J) is the energy density with these weights and the mean of the cells' B. It is not negative,
/// because means of admissible weights are admissible.
inline EnergyWeights jumpWeights(EnergyWeights i, EnergyWeights j) {
    return {0.5 * (i.q + j.q), std::min(0.5 * (i.r + j.r), 0.0)};
}

}  // namespace wend
