#pragma once

#include <optional>
#include <vector>

#include "app/project/pin.h"

namespace wend {

/// Returns the motions of a handle that grows or shrinks, or moves every vertex by its own displacement, led
/// through a pose at a time within it: exactly where it was plus a displacement times a factor that rises
/// linearly in time from 0 to 1 and falls back to 0. The factor of growth is linear in time, and so are the
/// parts of it. Those of an eased motion are exact at its ends, at the pose and where pieces of its path
/// join; between these they have the nearest easings, because a part of an easing is no easing. None for
/// other motions.
std::vector<PinMotion> ledWhileGrowing(const PinMotion& motion, const Vec3& by, double time);

/// Returns such a motion, eased or not, plus the displacement times a factor that goes from `first` to `last`
/// as the motion itself does. None for other motions.
std::vector<PinMotion> ledGrowth(const PinMotion& motion, const Vec3& by, double first, double last);

/// Returns one motion by what two do that follow each other, of which one at least grows and the other grows
/// or translates, or one at least is a field and the other a field or a translation; nothing for other
/// motions.
std::optional<PinMotion> joinedGrowth(const PinMotion& before, const PinMotion& after);

}  // namespace wend
