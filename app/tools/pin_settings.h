#pragma once

#include <algorithm>

#include "app/base/shared_value.h"
#include "app/project/edits/grip.h"
#include "app/tools/drawn_outline.h"

namespace wend {

/// Shared settings for selecting, adding and dragging pins.
struct PinSettings {
    Grip::Kind grip = Grip::Kind::Move;                           // effect of a drag on the selection
    DrawnOutline::Kind selectBy = DrawnOutline::Kind::Rectangle;  // shape of a marquee
    bool through = false;                                         // includes covered parts
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
