#pragma once

#include <string>

#include "app/session/shared_value.h"
#include "core/energy/material.h"
#include "core/mesh/region.h"

namespace wend {

/// What a stroke changes: what is kept (φ), how stiff the shape is, or along which direction.
enum class BrushTarget { Keep, Stiffness, Direction };
/// Where the direction of what is painted stiff comes from: the stroke's own way, what is stiff there
/// already, an axis of the rest shape, the direction of view, or the path of the selected pin.
enum class StiffAlong { Stroke, AsItIs, Axis, View, Way };

struct BrushSettings {
    BrushTarget target = BrushTarget::Keep;
    double phi = phi::kAkvf;
    double ratio = 10;  // how many times stiffer
    double amount = 1;  // of the way from what is there to what is painted
    StiffAlong along = StiffAlong::Stroke;
    Vec<3> axis = Vec<3>::UnitX();  // in the plane its first two numbers
    double radius = 38;             // on the screen, in pixels: nothing is painted beyond it
    double hardness = 0.6;          // the part of the radius that is painted wholly
    bool pressure = true;           // of a pen: it scales the amount
    bool operator==(const BrushSettings&) const = default;
};

BrushSettings bounded(BrushSettings brush);

/// The layer that is chosen, in the list or because it was painted last; none without a name.
struct ChosenLayer {
    std::string name;
    std::string aim = {};  // what the brush was to paint, if it was the last to paint there
    bool operator==(const ChosenLayer&) const = default;
};
inline ChosenLayer bounded(ChosenLayer layer) {
    return layer;
}
class LayerChoice : public SharedValue<ChosenLayer> {
  public:
    using SharedValue::SharedValue;
};

/// The one number that a brush lays down.
using PenValue = SharedValue<double>;

/// Regions of a solid that are to be seen.
using ChosenRegions = SharedValue<std::vector<Region<3>>>;
inline std::vector<Region<3>> bounded(std::vector<Region<3>> regions) {
    return regions;
}

/// The brush in the user's hand: one for all tools that paint, on pictures and on solids.
class Brush : public SharedValue<BrushSettings> {
  public:
    static constexpr double kSmallest = 4, kLargest = 300;  // pixels
    using SharedValue::SharedValue;

    LayerChoice& layer() { return m_layer; }
    /// How long edges of the mesh become where it is brushed, of those elsewhere.
    PenValue& edges() { return m_edges; }
    /// What is brushed lies in front where it is greater than 0, behind where it is less.
    PenValue& order() { return m_order; }
    /// Where the mesh is finer or coarser already, of what is chosen in the list of it.
    ChosenRegions& regions() { return m_regions; }

  private:
    PenValue m_edges{0.5}, m_order{1};
    ChosenRegions m_regions;
    LayerChoice m_layer;
};

}  // namespace wend
