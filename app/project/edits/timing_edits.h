#pragma once

#include <algorithm>
#include <compare>
#include <type_traits>
#include <vector>

#include "app/project/project_fwd.h"
#include "core/motion/handle.h"

namespace wend {

/// Edits of the times of motions: pure functions from a project to the next. Other motions keep their times,
/// so poses in between change. `handle` and `motion` are indices.

/// The time window of a motion.
struct MotionTime {
    double start = 0, end = 1;
    bool operator==(const MotionTime&) const = default;
};
MotionTime timeOf(const Design& design, int handle, int motion);

/// A motion to be moved together with others.
struct MotionId {
    int handle = -1, motion = -1;
    auto operator<=>(const MotionId&) const = default;
};
template <class Id>
bool isAmong(const std::vector<Id>& ids, const std::type_identity_t<Id>& one) {
    return std::find(ids.begin(), ids.end(), one) != ids.end();
}
/// Returns the interval from the first start to the last end.
MotionTime spanOf(const Design& design, const std::vector<MotionId>& motions);
/// Maps a time of motions whose span changes: moved and scaled.
double carried(double time, const MotionTime& from, const MotionTime& to);
/// Returns the possible span nearest to the wanted one: each motion stays between the others of its handle,
/// within the time that the handle holds, and at least kShortestMotion long. If one end is unchanged they are
/// scaled, else moved. The span may exceed the film, which becomes longer then.
inline constexpr double kShortestMotion = 0.02;
MotionTime fittedSpan(const Design& design, const std::vector<MotionId>& motions, const MotionTime& wanted);
Project withMotionSpan(const Project& project, const std::vector<MotionId>& motions,
                       const MotionTime& wanted);
Design withMotionEase(const Design& design, const std::vector<MotionId>& motions, Ease ease);
/// Returns the interval in which a handle holds, −∞ or +∞ for an open end.
MotionTime holdOf(const Design& design, int handle);
/// Sets that interval, which covers at least the handle's motions. A start at or before 0 and an end at or
/// after the film's end become open.
Design withHold(const Design& design, int handle, const MotionTime& hold, double filmEnd);
/// Removes motions. Later motions of the handle continue from the start of the removed ones; rotations keep
/// their centre.
Design withoutMotions(const Design& design, std::vector<MotionId> motions);

}  // namespace wend
