#pragma once

#include <optional>

#include "app/document/edits/handle_edits.h"

namespace wend {

/// Poses: where handles are at one time. The ends of a handle's motions are its key poses.

/// Sets where the handles of a gesture are at gesture.from, by the last point of its path. What they did up
/// to the key pose before and from the key pose after on stays; in between the way is led through the new
/// pose, by the displacement times a factor that rises from 0 to 1 and falls to 0 linearly in time. At a key
/// pose, that moves; elsewhere there is a new one. Nothing for other kinds of motions (rotations, frames,
/// fields, tables of poses), which cannot be led elsewhere, and at the start of a handle's time. `starts` are
/// the handles' places at that time.
template <int Dim>
std::optional<Project> withPose(const Project& project, const Gesture& gesture,
                                const std::vector<Vec<Dim>>& starts);

/// The same after all motion: the film becomes longer by `length`, in which the handles move to their new
/// places; all times that there were stay.
template <int Dim>
Project withPoseAppended(const Project& project, const Gesture& gesture, const std::vector<Vec<Dim>>& starts,
                         double length = 1);

}  // namespace wend
