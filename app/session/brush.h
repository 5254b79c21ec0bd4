#pragma once

#include <string>

#include "app/base/shared_value.h"
#include "app/project/id.h"
#include "core/energy/material.h"

namespace wend {

/// The property that a stroke changes: the kept quantity (φ), the stiffness or its direction.
enum class BrushTarget { Keep, Stiffness, Direction };
/// Source of the direction of painted stiffness: the stroke itself, the existing direction, an axis of the
/// rest shape, the direction of view, or the path of the selected pin.
enum class StiffAlong { Stroke, AsItIs, Axis, View, Way };

struct BrushSettings {
    BrushTarget target = BrushTarget::Keep;
    double phi = phi::kAkvf;
    double ratio = 10;  // how many times stiffer
    double amount = 1;  // blend factor from the existing to the painted value
    StiffAlong along = StiffAlong::Stroke;
    Vec3 axis = Vec3::UnitX();  // in the plane its first two numbers
    double radius = 38;         // on the screen, in pixels: nothing is painted beyond it
    double hardness = 0.6;      // the part of the radius that is painted wholly
    bool pressure = true;       // of a pen: it scales the amount
    bool operator==(const BrushSettings&) const = default;
};

BrushSettings bounded(BrushSettings brush);

/// The layer that is chosen, in the list or because it was painted last.
struct ChosenLayer {
    Id id = Id::None;
    std::string aim = {};  // the property that the brush painted here last
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

/// The brush settings that all painting tools share, on pictures and on solids.
class Brush : public SharedValue<BrushSettings> {
  public:
    static constexpr double kSmallest = 4, kLargest = 300;  // pixels
    using SharedValue::SharedValue;

    LayerChoice& layer() { return m_layer; }
    /// Edge length in brushed places, relative to the length elsewhere.
    PenValue& edges() { return m_edges; }
    /// Depth of brushed places: in front if positive, behind if negative.
    PenValue& order() { return m_order; }

  private:
    PenValue m_edges{0.5}, m_order{1};
    LayerChoice m_layer;
};

}  // namespace wend
