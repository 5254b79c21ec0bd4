#pragma once

#include <algorithm>
#include <compare>
#include <vector>

#include "app/document/project_fwd.h"
#include "core/motion/handle.h"

namespace wend {

/// When motions of a film happen: pure functions from a project to the next one. Other motions keep their
/// times, so the poses on the way change. `handle` and `motion` are indices.

/// The time window of a motion.
struct MotionTime {
    double start = 0, end = 1;
    bool operator==(const MotionTime&) const = default;
};
MotionTime timeOf(const AnyDesign& design, int handle, int motion);

/// One of the motions that are put elsewhere together.
struct MotionId {
    int handle = -1, motion = -1;
    auto operator<=>(const MotionId&) const = default;
};
inline bool isAmong(const std::vector<MotionId>& motions, const MotionId& one) {
    return std::find(motions.begin(), motions.end(), one) != motions.end();
}
/// From when the first of them begins until the last one ends.
MotionTime spanOf(const AnyDesign& design, const std::vector<MotionId>& motions);
/// A time of motions whose span becomes another one: moved, and scaled.
double carried(double time, const MotionTime& from, const MotionTime& to);
/// The span nearest to the wanted one that they can have: each motion stays between the others of its handle
/// and within the time that the handle holds, and is at least kShortestMotion long. With one end as it is
/// they are scaled, else moved. Beyond the end of the film there is room; it becomes longer then.
inline constexpr double kShortestMotion = 0.02;
MotionTime fittedSpan(const AnyDesign& design, const std::vector<MotionId>& motions,
                      const MotionTime& wanted);
Project withMotionSpan(const Project& project, const std::vector<MotionId>& motions,
                       const MotionTime& wanted);
AnyDesign withMotionEase(const AnyDesign& design, const std::vector<MotionId>& motions, Ease ease);
/// From when until when a handle holds: −∞ and +∞ where it has no beginning or no end.
MotionTime holdOf(const AnyDesign& design, int handle);
/// No shorter than its motions. What begins at 0 or before has no beginning then, what ends at the end of the
/// film or later no end.
AnyDesign withHold(const AnyDesign& design, int handle, const MotionTime& hold, double filmEnd);
/// What a handle does later goes on from where the motion would have begun; rotations keep their centre.
AnyDesign withoutMotions(const AnyDesign& design, std::vector<MotionId> motions);

}  // namespace wend
