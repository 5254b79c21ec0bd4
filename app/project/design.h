#pragma once

#include <algorithm>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/project/layer.h"
#include "app/project/pin.h"
#include "core/energy/material.h"
#include "core/mesh/region.h"

namespace wend {

/// Stiffness along a direction: one axis, or in every cell the normal of the nearest place of a wall.
struct Stiffness {
    Vec3 axis;
    double ratio = 1;       // s ≥ 1: B₀ = I + (s − 1) a aᵀ
    std::string wall = {};  // the group of the mesh's file that is the wall; empty: the axis counts
    double within =
        std::numeric_limits<double>::infinity();      // the distance from the wall up to which it holds
    std::shared_ptr<const GuideMesh<3>> facets = {};  // of the wall
};

/// Pictures of a 2D region's φ, stiffness and direction: see material_picture.h. An empty name keeps the
/// existing values.
struct MaterialPictures {
    std::string phi, stiffness, direction;
    bool up = false;   // the first row has the largest y
    int readings = 0;  // increases when the files were rewritten; not stored

    bool any() const { return !(phi + stiffness + direction).empty(); }
    bool operator==(const MaterialPictures&) const = default;
};

struct MaterialRegion : SoftRegion {
    std::optional<double> phi = {};
    std::optional<Stiffness> stiffness = {};
    MaterialPictures pictures = {};  // in the plane only, instead of phi and stiffness; they fill a box
    bool hidden = false;             // changes nothing, as if it were not there
    double leaves = 1;               // less than 1: an eraser, which leaves this part of its layer's paint

    bool erases() const { return leaves < 1; }
};

/// Regions of the material that were painted together: in a file consecutive regions of one name. An eraser
/// takes paint from its own layer.
struct MaterialLayer {
    std::string name;  // may be empty
    std::vector<MaterialRegion> regions;
    Id id = newId();

    bool isHidden() const { return std::ranges::any_of(regions, &MaterialRegion::hidden); }
    bool erases() const { return std::ranges::any_of(regions, &MaterialRegion::erases); }
};

struct MaterialSpec {
    double phi = phi::kMetr;
    Smoothing smoothing;
    double memory = 0;                  // ρ
    std::vector<MaterialLayer> layers;  // later ones win
    std::vector<double> cellPhi;        // material.cells, if given
    std::vector<Mat3> cellB;
    std::string cellsFile;         // where material.cells names a file
    std::string cellsPhi, cellsB;  // fields of that file; empty: "phi" and "B", as far as they are there
};

/// The material and the handles. In the plane z is 0, and matrices leave z as it is.
struct Design {
    MaterialSpec material;
    std::vector<Pin> handles;
    int dimension = 2;  // of the shape, see Project::dimension()
};

}  // namespace wend
