#pragma once

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "core/mesh/simplicial_mesh.h"

namespace wend {

/// φ of the four named energies (docs/method.md, section 2).
namespace phi {
inline const double kEquia = std::atan(std::ldexp(1.0, -9));  // keeps area or volume
inline const double kMetr = std::atan(0.5);                   // keeps length (AMAP)
inline constexpr double kAkvf = std::numbers::pi / 2;         // Killing: as rigid as possible
/// Returns φ_CONF(d) = π − arctan(d/4), the end of the range, which keeps angles (ACAP). `dim` is 2 or 3.
double conformal(int dim);
/// Returns an empty string if φ is in ]0, φ_CONF(dim)] (φ_CONF included, with an allowance for rounding),
/// else the reason with the range. The allowance is 1e-14, so that φ_CONF survives a round trip through 16
/// digits of text; NaN is a problem.
std::string problem(double phi, int dim);
}  // namespace phi

/// Selects what the smoothness penalizes: jumps of J in q (Invariant), jumps of the stress (Paper), or
/// nothing.
enum class SmoothingKind { Invariant, Paper, None };

/// The weights of jumps over facets, in the frame where the rest shape has size 1 (docs/method.md, section
/// 4).
struct Smoothing {
    SmoothingKind kind = SmoothingKind::Invariant;
    double length = 1.0 / 75;  // s, Invariant: s² (B/h) q(J_j − J_i)
    double lambda = 0.1;       // λ, Paper: λ B ‖P_j − P_i‖²
};

/// The material per cell: the energy parameter φ, and the anisotropy B₀ at rest, which rotates with the
/// material.
template <int Dim>
struct Material {
    std::vector<double> phi;           // one per cell, in ]0, φ_CONF(Dim)]
    std::vector<Mat<Dim>> anisotropy;  // one symmetric positive definite B₀ per cell, or empty: all identity
    Smoothing smoothing;
    // ρ ≥ 0: rate at which the shape returns to rest; infinite: it is elastic (docs/method.md, section 8).
    double memory = 0;

    /// Returns a material with the same φ in every cell and B₀ = I.
    static Material uniform(int cellCount, double phi, Smoothing smoothing = {});
};

/// Throws InputError naming the cell and the range for φ outside ]0, φ_CONF], B not symmetric positive
/// definite, or a wrong count. B counts as symmetric up to 1e-9 of its norm, and as positive definite if its
/// least eigenvalue exceeds 1e-12 of the greatest. A smoothing parameter in use and the memory must be
/// numbers ≥ 0; the memory may be infinite.
template <int Dim>
void requireValid(const Material<Dim>& material, int cellCount);

}  // namespace wend
