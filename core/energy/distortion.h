#pragma once

#include <vector>

#include "core/mesh/simplicial_mesh.h"

namespace wend {

/// Measures of how far a pose is from rest (docs/method.md, (26)–(28)), per cell and as means weighted with
/// the cells' measures at rest. All are dimensionless, and 0 where the map of a cell from rest is a rotation.
struct Distortion {
    std::vector<double> angle, volume, metric;  // per cell, unweighted
    std::vector<double> ratio;                  // det F: area or volume change per cell, 1 = kept
    double totalAngle = 0, totalVolume = 0, totalMetric = 0;
    int flips = 0;       // cells with det F ≤ 0
    double minDet = 1;   // the least det F
    int worstCell = -1;  // cell of the largest metric error
};

/// Returns the distortion of `pose` (Dim × n) against `rest`. With the singular values σ of a cell's
/// deformation gradient F, det = Π σ, and the terms of docs/method.md, (26)–(28), written without
/// cancellation near rest:
///   angle   Σ_{j<k} (σ_j − σ_k)² / (σ_j σ_k)   (= Σ_{j<k} (σ_j/σ_k + σ_k/σ_j − 2))
///   volume  (det − 1)² / det                   (= det + 1/det − 2)
///   metric  Σ_j (σ_j − 1)² − Σ_{j<k} (σ_j − σ_k)² / (Dim + 2)
/// Totals are Σ_c V_c m_c / Σ_c V_c with the absolute measures V_c at rest. σ has no sign: a mirrored cell
/// counts as its mirror image in all three, and is found by `ratio`, `flips` and `minDet` alone. A cell that
/// is flat in the pose has an infinite or NaN angle and volume, and so have the totals then; a NaN
/// determinant counts as a flip. The worst cell is the first of several; −1 if no cell has one.
template <int Dim>
Distortion distortion(const SimplicialMesh<Dim>& rest, const Points<Dim>& pose);

}  // namespace wend
