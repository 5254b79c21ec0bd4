#pragma once

#include "core/energy/mandel.h"
#include "core/mesh/simplicial_mesh.h"

namespace wend {

/// The gradient operator of one cell: the (constant) gradients g_k of its hat functions, one column per
/// corner, and its signed measure. The Jacobian of a nodal field is J = Σ_k v_k g_kᵀ. Gradients have the unit
/// 1 / length; those of a cell without measure are not finite. The gradients are columns of a Dim × (Dim + 1)
/// matrix and sum to zero; hat function k is 1 at corner k and 0 at the others.
template <int Dim>
struct CellGeometry {
    Eigen::Matrix<double, Dim, Dim + 1> gradients;
    double measure = 0;
};
/// Returns the gradient operator of a cell with its corners at `points` (Dim × n): with the edge matrix E the
/// gradients of the corners 1 … d are the rows of E⁻¹, that of corner 0 is minus their sum, and the measure
/// is det E / d!, negative for a cell of negative orientation.
template <int Dim>
CellGeometry<Dim> cellGeometry(const Points<Dim>& points, const Cell<Dim>& cell);

/// The weights of the two parts of the energy, w_q = sin φ and w_r = cos φ (docs/method.md, (4)).
struct EnergyWeights {
    double q = 0, r = 0;
    /// Returns the weights at φ in radians; the range is not checked, see phi::problem().
    static EnergyWeights of(double phi);
};

/// Returns the energy density e(J) = w_q ‖S‖²_B + w_r (d / Tr B) (Tr BJ)², S = J + Jᵀ, ‖A‖²_B = Tr(Aᵀ B A)
/// (docs/method.md, (3)). The cell's energy is its measure times this. B must be symmetric positive definite
/// and J is Dim × Dim, in 1 / time; the density is in 1 / time². It is zero for every rotation rate J = −Jᵀ,
/// and not negative for φ in ]0, φ_CONF]; at φ_CONF with B = I also for J ∝ I.
template <int Dim>
double energyDensity(EnergyWeights w, const Mat<Dim>& B, const Mat<Dim>& J);

/// Returns the stress P = ∂e/∂J = 2 w_q (SB + BS) + 2 w_r (d / Tr B) Tr(BJ) B (docs/method.md, (8)), Dim ×
/// Dim. It is symmetric, linear in J, and e = ½ J : P.
template <int Dim>
Mat<Dim> stress(EnergyWeights w, const Mat<Dim>& B, const Mat<Dim>& J);

/// Returns the same as a matrix D in Mandel coordinates, P = D S. It is symmetric, and positive semidefinite
/// for φ in ]0, φ_CONF] (definite below φ_CONF, with B in its null space at φ_CONF if B = I); e = ¼ Sᵀ D S.
/// It has 3 × 3 entries in the plane and 6 × 6 in space, in the order of toMandel().
template <int Dim>
StressMatrix<Dim> stressMatrix(EnergyWeights w, const Mat<Dim>& B);

/// Returns the block of the matrix of 4 e between two corners with hat gradients g and h: uᵀ K v = S(u gᵀ) :
/// D S(v hᵀ) with S(A) = A + Aᵀ, that is
///   4 w_q ((Bh) gᵀ + (g·h) B + (g·Bh) I + h (Bg)ᵀ) + 4 w_r (d / Tr B) (Bg) (Bh)ᵀ.
/// The block for (h, g) is its transpose. With w_r = 0, as at AKVF, the last term is left out.
template <int Dim>
Mat<Dim> stressBlock(EnergyWeights w, const Mat<Dim>& B, const Vec<Dim>& g, const Vec<Dim>& h);

/// Returns the rotation R of the polar decomposition F = R U of a map with det F > 0 (docs/method.md, (7)),
/// accurate to rounding: in the plane the normalized conformal part of F, in space by Newton's iteration with
/// Higham's scaling, which takes about six inversions. Without det F > 0 the result may be NaN, and in space
/// a reflection.
template <int Dim>
Mat<Dim> polarRotation(const Mat<Dim>& F);

/// Returns the edge matrix [x_1 − x_0, …, x_d − x_0]. The map of a cell from rest is edgeMatrix(pose) ·
/// edgeMatrix(rest)⁻¹. Column k − 1 is the edge from corner 0 to corner k; det / Dim! is the cell's signed
/// measure.
template <int Dim>
Mat<Dim> edgeMatrix(const Points<Dim>& points, const Cell<Dim>& cell);

}  // namespace wend
