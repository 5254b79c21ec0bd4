#pragma once

#include <memory>
#include <span>
#include <string>

#include "app/project/design.h"
#include "core/energy/material.h"

namespace wend {

/// Returns φ and B of every cell at its centroid. Starting from the cells' own values, if the spec has them,
/// each region blends in its φ and B with its membership m: φ + m (φ_region − φ) and (1 − m) B + m B_region,
/// which stays symmetric positive definite. An eraser reverts its layer:
/// the cover c, which a region raises to c + m (1 − c), becomes c' = (1 − m) c + m min(c, leaves), and φ and
/// B move to those below the layer by c'/c. A file of cell values is read from `folder`. Throws InputError
/// that names the key.
template <int Dim>
std::shared_ptr<const Material<Dim>> rasterizeMaterial(const MaterialSpec& spec,
                                                       const SimplicialMesh<Dim>& rest,
                                                       const std::string& folder = {});

/// Adds layers to a material, as rasterizeMaterial() does.
template <int Dim>
void layLayers(std::span<const MaterialLayer> layers, const SimplicialMesh<Dim>& rest,
               const std::string& folder, Material<Dim>& material);
/// Returns the cover c of a layer, per cell.
template <int Dim>
std::vector<double> coverOf(const MaterialLayer& layer, const SimplicialMesh<Dim>& rest,
                            const std::string& folder);

/// Return B₀ of a stiffness, and the stiffness nearest to a B₀: along its largest eigenvector, by the ratio
/// of the largest eigenvalue to the smallest.
template <int Dim>
Mat<Dim> anisotropyOf(const Stiffness& stiffness);
template <int Dim>
Stiffness stiffnessOf(const Mat<Dim>& B);

}  // namespace wend
