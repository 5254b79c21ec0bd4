#pragma once

#include "core/energy/cell_energy.h"

namespace wend {

/// Energy density w of the map from rest with deformation gradient F, J = det F (docs/method.md, (20) and
/// (21)); infinite for J ≤ 0. Its second-order expansion at F = I is energyDensity(w, B₀, F − I). For B₀ = I
///   w = 2 w_q (‖F‖² J^(−2/d) − d) + (4 w_q/d + w_r)(J + 1/J − 2),
/// else, with C = FᵀF,
///   w = w_q ‖C − I‖²_B₀ + w_r (d/Tr B₀)(½ Tr B₀(C − I))² + w_q (Tr B₀/d)(J − 1)⁴/J.
template <int Dim>
double restDensity(EnergyWeights w, const Mat<Dim>& B0, const Mat<Dim>& F);

/// ∂w/∂F, for J > 0; exactly zero where F is a rotation to rounding.
template <int Dim>
Mat<Dim> restStress(EnergyWeights w, const Mat<Dim>& B0, const Mat<Dim>& F);

}  // namespace wend
