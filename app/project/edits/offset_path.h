#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "app/project/pin.h"

namespace wend {

/// The path of a motion that only translates: offsets from its start, by time; linear in between.
struct OffsetPath {
    std::vector<double> times;
    std::vector<Vec3> offsets;

    Vec3 at(double time) const;
    /// Returns the offsets plus a displacement, times a factor that is linear in time.
    OffsetPath led(const Vec3& by, double first, double last) const;
};

/// Returns the path of a motion that only translates, exact at one time; nothing for any other motion.
std::optional<OffsetPath> offsetPathOf(const PinMotion& motion, double time);
/// Returns the offset from the start to the end of such a motion.
std::optional<Vec3> offsetOf(const PinMotion& motion);
/// Returns both parts of a path that is split at a time within it.
std::pair<OffsetPath, OffsetPath> split(const OffsetPath& path, double time);
/// Returns a motion along a path from a place.
PinMotion motionAlong(const OffsetPath& path, const Vec3& place);
/// Returns the motion with a displacement times a factor from `first` to `last`, starting at a place. One
/// that is straight, or a chain of cubics, stays so, with its easing. Nothing for motions that do not only
/// translate.
std::optional<PinMotion> led(const PinMotion& motion, const Vec3& by, double first, double last,
                             const Vec3& place);

}  // namespace wend
