#pragma once

#include "core/energy/cell_energy.h"

namespace wend {

/// Returns the energy density w of the map from rest with deformation gradient F, J = det F (docs/method.md,
/// (20) and (21)); infinite for J ≤ 0. Its second-order expansion at F = I is energyDensity(w, B₀, F − I).
/// For B₀ = I
///   w = 2 w_q (‖F‖² J^(−2/d) − d) + (4 w_q/d + w_r)(J + 1/J − 2),
/// else, with C = FᵀF,
///   w = w_q ‖C − I‖²_B₀ + w_r (d/Tr B₀)(½ Tr B₀(C − I))² + w_q (Tr B₀/d)(J − 1)⁴/J.
/// It is dimensionless, not negative for φ in ]0, φ_CONF], and 0 for rotations; at φ_CONF with B₀ = I it is 0
/// for all similarities. B₀ counts as the identity only if every entry is exactly that of I.
template <int Dim>
double restDensity(EnergyWeights w, const Mat<Dim>& B0, const Mat<Dim>& F);

/// Returns ∂w/∂F (Dim × Dim) for J > 0, the first Piola–Kirchhoff stress; it is exactly zero where F is a
/// rotation to rounding, ‖FᵀF − I‖ ≤ 1e-12, so that a shape that has only moved feels no force. With C = FᵀF
/// and the constants of restHessian() it is a F + (k (J − 1/J) − a ‖F‖²/d) F⁻ᵀ for B₀ = I, else
///   2 F (w_q (B₀(C − I) + (C − I)B₀) + ½ w_r (d/Tr B₀) Tr(B₀(C − I)) B₀)
///   + w_q (Tr B₀/d) (J − 1)³ (3J + 1)/J F⁻ᵀ.
template <int Dim>
Mat<Dim> restStress(EnergyWeights w, const Mat<Dim>& B0, const Mat<Dim>& F);

/// The eigenvalues and eigenvectors of the Hessian ∂²w/∂F², a symmetric matrix on the entries of F column by
/// column: ∂²w/∂F² = Σ_m values_m modes_m modes_mᵀ with orthonormal columns modes_m, for J > 0.
template <int Dim>
struct RestModes {
    static constexpr int kCount = Dim * Dim;
    Eigen::Matrix<double, kCount, 1> values;
    Eigen::Matrix<double, kCount, kCount> modes;
};
/// Returns the modes. For B₀ = I they follow from the singular values F = U diag(σ) Vᵀ: with ψ(σ) = w, every
/// pair has a twist U (e_i e_jᵀ − e_j e_iᵀ) Vᵀ/√2 and a flip U (e_i e_jᵀ + e_j e_iᵀ) Vᵀ/√2 with the
/// eigenvalues (ψ_i ± ψ_j)/(σ_i ± σ_j), and the eigenvectors of ∂²ψ/∂σ² are stretches (Smith, De Goes, Kim,
/// "Analytic Eigensystems for Isotropic Distortion Energies", 2019). Otherwise they come from a numerical
/// decomposition. The order of the modes differs between both ways and is of no meaning. Clamping `values` at
/// 0 gives the nearest positive semidefinite Hessian in the Frobenius norm, as Newton's method needs it.
template <int Dim>
RestModes<Dim> restModes(EnergyWeights w, const Mat<Dim>& B0, const Mat<Dim>& F);

/// A symmetric matrix on the corners 1 … of a cell: coordinate a of corner k is number Dim · (k − 1) + a.
template <int Dim>
using CornerHessian = Eigen::Matrix<double, Dim * Dim, Dim * Dim>;
/// Returns ∂²w/∂x_k ∂x_l at the corners of a cell whose columns of `hats` are the hat gradients h_k at rest,
/// for J > 0. For B₀ = I, with f_k = F h_k, n_k = F⁻ᵀ h_k, a = 4 w_q J^(−2/d), k = 4 w_q/d + w_r, s = ‖F‖²,
/// b = k (J − 1/J) − a s/d and c = k (J + 1/J) + 2 a s/d², the block of two corners is
///   a (h_k · h_l) I − (2a/d) (f_k n_lᵀ + n_k f_lᵀ) + c n_k n_lᵀ − b n_l n_kᵀ.
/// The matrix is exactly symmetric, but indefinite in general. The blocks of corner 0 follow from h_0 = −Σ
/// h_k.
template <int Dim>
CornerHessian<Dim> restHessian(EnergyWeights w, const Mat<Dim>& B0, const Mat<Dim>& F, const Mat<Dim>& hats);

}  // namespace wend
