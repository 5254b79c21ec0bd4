#pragma once

#include <memory>
#include <string>

#include "app/document/design.h"
#include "core/energy/material.h"

namespace wend {

/// φ and B of every cell, taken at its centroid. On the cells' own values, if the spec has them, each region
/// in turn lays its φ and B with its membership m: φ + m (φ_region − φ) and (1 − m) B + m B_region, which
/// stays symmetric positive definite. A file with the cells' values is read from `folder`. Throws InputError
/// that names the key.
template <int Dim>
std::shared_ptr<const Material<Dim>> rasterizeMaterial(const MaterialSpec<Dim>& spec,
                                                       const SimplicialMesh<Dim>& rest,
                                                       const std::string& folder = {});

/// One region more upon a material, at the cells' centroids, as rasterizeMaterial() lays each in turn.
template <int Dim>
void layRegion(const MaterialRegion<Dim>& region, const SimplicialMesh<Dim>& rest, Material<Dim>& material);

/// B₀ of a stiffness, and the stiffness that comes nearest to a B₀: along its largest eigenvalue, by how
/// much that is more than the least.
template <int Dim>
Mat<Dim> anisotropyOf(const Stiffness<Dim>& stiffness);
template <int Dim>
Stiffness<Dim> stiffnessOf(const Mat<Dim>& B);

}  // namespace wend
