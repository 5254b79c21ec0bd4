#pragma once

#include "app/document/project_fwd.h"
#include "core/motion/handle.h"

namespace wend {

/// When single motions of a film happen: pure functions from a project to the next one. Other motions keep
/// their times, so the poses on the way change. `handle` and `motion` are indices.

/// The time window of a motion.
struct MotionTime {
    double start = 0, end = 1;
    bool operator==(const MotionTime&) const = default;
};
MotionTime timeOf(const AnyDesign& design, int handle, int motion);
/// How far the window may reach: to the motions of the same handle before and after it, and no further than
/// the handle holds. +∞ where nothing comes after; the film becomes longer then.
MotionTime roomOf(const AnyDesign& design, int handle, int motion);
/// The nearest window within that room; at least kShortestMotion long.
inline constexpr double kShortestMotion = 0.02;
Project withMotionTime(const Project& project, int handle, int motion, const MotionTime& time);
AnyDesign withMotionEase(const AnyDesign& design, int handle, int motion, Ease ease);
/// From when until when a handle holds: −∞ and +∞ where it has no beginning or no end.
MotionTime holdOf(const AnyDesign& design, int handle);
/// No shorter than its motions. What begins at 0 or before has no beginning then, what ends at the end of the
/// film or later no end.
AnyDesign withHold(const AnyDesign& design, int handle, const MotionTime& hold, double filmEnd);
/// What the handle does later goes on from where the motion would have begun; rotations keep their centre.
AnyDesign withoutMotion(const AnyDesign& design, int handle, int motion);

}  // namespace wend
