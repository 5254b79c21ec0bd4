#pragma once

#include <algorithm>

#include "app/document/edits/grip.h"
#include "app/session/shared_value.h"
#include "app/tools/drawn_outline.h"

namespace wend {

/// How pins are taken, set and dragged, with whatever tool.
struct PinSettings {
    Grip::Kind grip = Grip::Kind::Move;                           // what a drag does with what is selected
    DrawnOutline::Kind selectBy = DrawnOutline::Kind::Rectangle;  // what is drawn beside pins
    bool through = false;                                         // what is hidden is taken and selected, too
    bool snaps = false;  // new pins sit on corners of the mesh, instead of where one clicks
    double radius = 18;  // of the brush that takes and selects, in pixels
    static constexpr double kSmallest = 4, kLargest = 200;
    bool operator==(const PinSettings&) const = default;
};

inline PinSettings bounded(PinSettings settings) {
    settings.radius = std::clamp(settings.radius, PinSettings::kSmallest, PinSettings::kLargest);
    return settings;
}

/// Chosen by the user, once for pictures and solids.
using PinChoice = SharedValue<PinSettings>;

}  // namespace wend
