#pragma once

#include <vector>

#include "core/mesh/simplicial_mesh.h"

namespace wend {

/// Measures of how far a pose is from rest (docs/method.md, (24)–(26)), per cell and as means weighted with
/// rest volume fractions.
struct Distortion {
    std::vector<double> angle, volume, metric;  // per cell, unweighted
    std::vector<double> ratio;                  // det F: area or volume change per cell, 1 = kept
    double totalAngle = 0, totalVolume = 0, totalMetric = 0;
    int flips = 0;       // cells with det F ≤ 0
    double minDet = 1;   // the least det F
    int worstCell = -1;  // cell of the largest metric error
};

/// Returns the distortion of `pose` (Dim × n) against `rest`, by the singular values σ of each cell's
/// deformation gradient F (docs/method.md, (24)–(26)): angle Σ_{j<k} (σ_j − σ_k)² / (σ_j σ_k), volume (det −
/// 1)² / det with det = Π σ, metric Σ (σ_j − 1)² − Σ_{j<k} (σ_j − σ_k)² / (Dim + 2). Totals are means
/// weighted with the cells' rest measures. All values are dimensionless and zero for rigid motions;
/// degenerate cells give infinity or NaN.
template <int Dim>
Distortion distortion(const SimplicialMesh<Dim>& rest, const Points<Dim>& pose);

}  // namespace wend
