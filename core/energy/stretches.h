#pragma once

#include <array>

namespace wend {

/// The maps of many cells side by side, so that one instruction handles several of them.
template <int Dim>
struct Stretches {
    static constexpr int kCells = 64;
    using Lane = std::array<double, kCells>;

    std::array<Lane, Dim * Dim> maps;  // F, column by column
    std::array<Lane, Dim> sigma;       // its singular values
    Lane determinant;                  // of F
    std::array<bool, kCells> isExact;  // false where F is so far from rigid that σ lost digits
};

/// Computes `sigma` (in decreasing order, ≥ 0) and `determinant` of all `kCells` lanes from `maps`; the
/// caller ignores unused lanes, whose results may be NaN. In 2D by the conformal and anticonformal parts of
/// F, which is accurate everywhere. In 3D σ = √(1 + δ) with the eigenvalues δ of the strain FᵀF − I by the
/// trigonometric formula, with three Newton steps for the cosine: full accuracy near rigid maps; `isExact` is
/// false where an eigenvalue of FᵀF is outside ]0.05, 20[ and the caller should use an SVD. The strain is
/// used instead of FᵀF because σ − 1 would otherwise keep no digits near rigid maps. A lane's result does not
/// depend on the other lanes, but differs in the last digits between SIMD targets.
void computeStretches(Stretches<2>& cells);
void computeStretches(Stretches<3>& cells);

}  // namespace wend
