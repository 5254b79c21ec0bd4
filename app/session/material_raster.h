#pragma once

#include "app/document/project.h"

namespace wend {

/// One region more upon a material, at the cells' centroids, as rasterizeMaterial() lays each in turn.
template <int Dim>
void layRegion(const MaterialRegion<Dim>& region, const SimplicialMesh<Dim>& rest, Material<Dim>& material);

/// B₀ of a stiffness, and the stiffness that comes nearest to a B₀: along its greatest eigenvalue, by how
/// much that is more than the least.
template <int Dim>
Mat<Dim> anisotropyOf(const Stiffness<Dim>& stiffness);
template <int Dim>
Stiffness<Dim> stiffnessOf(const Mat<Dim>& B);

}  // namespace wend
