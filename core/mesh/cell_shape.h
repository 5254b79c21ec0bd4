#pragma once

#include "core/mesh/simplicial_mesh.h"

namespace wend {

/// Measures how far a cell is from the regular one, as the Verdict library does (Knupp et al., The Verdict
/// Geometric Quality Library, 2006). With the edges l, the measure V, the radius r of the inscribed ball, and
/// J = d! V:
///   scaled Jacobian  √2 J / max of the products of the three edges at a corner
///                    (plane: 2/√3 J / max l_i l_j),
///   aspect ratio     max l / (2 √6 r) (plane: max l Σ l / (4 √3 V)).
/// Both are dimensionless, and 1 for the regular cell. The scaled Jacobian decreases to 0 for a flat cell and
/// is negative for an inverted one; the aspect ratio grows without bound.
struct CellShape {
    double scaledJacobian = 0, aspectRatio = 0;
    double minAngle = 0, maxAngle = 0;  // radians: dihedral angles, in the plane those at the corners
};

/// Computes the shape of one cell. A flat one has the aspect ratio ∞, a single point the scaled Jacobian 0.
template <int Dim>
CellShape cellShape(const Points<Dim>& points, const Cell<Dim>& cell);

/// Computes the shapes of all cells.
template <int Dim>
std::vector<CellShape> cellShapes(const Points<Dim>& points, const std::vector<Cell<Dim>>& cells);

/// Returns the deformation gradient F of every cell, the gradient of its map from rest: F (x_i − x_0) =
/// pose_i − pose_0. F is Dim × Dim and dimensionless. `pose` is Dim × n as the points of `rest`, none of
/// whose cells may be flat.
template <int Dim>
std::vector<Mat<Dim>> deformationGradients(const SimplicialMesh<Dim>& rest, const Points<Dim>& pose);

}  // namespace wend
