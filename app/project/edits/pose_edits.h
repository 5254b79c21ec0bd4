#pragma once

#include <optional>

#include "app/project/edits/handle_edits.h"

namespace wend {

/// Poses: where handles are at one time. The ends of a handle's motions are its key poses.

/// Leads the motions of a handle, which is at a place at that time, through a pose beside it; see withPose().
/// Returns false, and leaves the handle, if they cannot be led there.
bool poseAt(Pin& handle, const Vec3& place, const Vec3& by, double time);

/// Sets where the handles of a gesture are at gesture.from, by the last point of its path. Their motion
/// before the previous key pose and after the next one stays. In between, the path is led through the new
/// pose, by the displacement times a factor that rises linearly in time from 0 to 1 and falls back to 0. At a
/// key pose, that pose moves; elsewhere a new one is added. An even rotation becomes rotations about other
/// centres, which lead it through the pose on arcs; an even scaling or field stays one; other rotations keep
/// their course and become tables of poses. Returns nothing for scalings and fields that are eased, unless
/// the pose is at their ends, and at the start of a handle's time. `starts` are the handles' places at that
/// time.
std::optional<Project> withPose(const Project& project, const Gesture& gesture,
                                const std::vector<Vec3>& starts);

/// Does the same after all motion: the film becomes longer by `length`, in which the handles move to their
/// new places; all earlier times stay.
Project withPoseAppended(const Project& project, const Gesture& gesture, const std::vector<Vec3>& starts,
                         double length = 1);

/// Replaces the last moves of the handles, which end with the film, by straight ones to their new places.
/// Returns nothing if they are other kinds of motions.
std::optional<Project> withLastMoveCorrected(const Project& project, const Gesture& gesture);

}  // namespace wend
