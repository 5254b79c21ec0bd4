#pragma once

#include "app/project/pin.h"
#include "app/project/project_fwd.h"

namespace wend {

/// The timing of a film is independent of posing: the film has a length, which gestures share in proportion
/// to their path lengths. All functions are pure.

/// Returns the path length of a motion in domain units; rotation and scaling count at the radius `arm`.
double pathLength(const PinMotion& motion, double arm);
/// Returns the total path length from pose to pose: of simultaneous motions the longest counts. Handles that
/// are points or regions have their own arms; `arm` is that of all others.
double pathLength(const std::vector<Pin>& handles, double arm);

/// Returns whether the user has timed motions: with pauses, overlaps, different speeds, easing or recorded
/// rhythms. Motions that were only posed follow each other in proportion to their lengths. Respacing would
/// change what was timed.
bool hasOwnTiming(const Project& project);

/// Returns the project up to a time: running motions are cut, later ones are removed. Pins that start later
/// now start at the very end; those that would be released later hold on.
Project endedAt(const Project& project, double time);
/// Cuts the motions of one handle at a time.
void endMotionsAt(Pin& handle, double time);

/// Returns the project with the same poses at other times, mapped by the straight lines [0, from] → [0, to]
/// and [from, end] → [to, end].
Project withTimesMoved(Project project, double from, double to);
/// Returns the project with the same poses in a film of another length.
Project withLength(Project project, double length);

}  // namespace wend
