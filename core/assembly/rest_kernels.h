#pragma once

#include "core/assembly/isotropic_kernels.h"

namespace wend::rest {

/// Holds the arrays of RestEnergy for B₀ = I, structures of arrays as in isotropic::Cells: number i of cell c
/// is at [i · padded(count) + c]. Cells beyond the last one repeat it, with the measure 0.
template <int Dim>
struct Cells {
    static constexpr int kCorners = Dim + 1;
    static constexpr int kPoint = isotropic::Cells<Dim>::kPoint;
    static constexpr int kTangent = 2 * Dim * Dim + 3;

    int count = 0;
    const int* vertices = nullptr;  // of cell c at kCorners · c
    const double *q = nullptr, *r = nullptr;
    const double* measure = nullptr;  // V₀
    const double* hats = nullptr;  // Dim × Dim: number Dim · (k − 1) + a of corner k ≥ 1, gradients at rest
};

/// Returns Σ V₀ w(F) of the cells [begin, end), infinite if one of them is inverted. Here and below, `begin`
/// is a multiple of isotropic::kPadding, and so is `end` unless it is the count.
template <int Dim>
double energy(const Cells<Dim>& cells, int begin, int end, const double* points);

/// Computes the forces V₀ ∂w/∂F h_k of a cell on its corners and stores them at kPoint · (kCorners · cell +
/// corner). They are zero where F is a rotation to rounding.
template <int Dim>
void forces(const Cells<Dim>& cells, int begin, int end, const double* points, double* force);

/// Computes what products() needs of a shape, kTangent numbers a cell: F and F⁻ᵀ row by row, then V₀ a, V₀ b
/// and V₀ c of restHessian().
template <int Dim>
void linearize(const Cells<Dim>& cells, int begin, int end, const double* points, double* tangent);

/// Computes V₀ (∂²w/∂F² : D) h_k for the gradient D of a field at rest, and stores it as forces() does: with
/// N = F⁻ᵀ, ∂²w/∂F² : D = a D − (2a/d) ((N : D) F + (F : D) N) + c (N : D) N − b N Dᵀ N.
template <int Dim>
void products(const Cells<Dim>& cells, int begin, int end, const double* tangent, const double* v,
              double* force);

/// Returns whether the Bernstein coefficients on [0, 1] of det(F + s D) are positive in every cell, for the
/// maps F of a shape and the gradients D of a step: then no cell is flat anywhere on it.
template <int Dim>
bool staysPositive(const Cells<Dim>& cells, int begin, int end, const double* points, const double* step);

}  // namespace wend::rest
