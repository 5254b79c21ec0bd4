#pragma once

#include <optional>

#include "app/document/edits/key_edits.h"
#include "core/motion/handle.h"

namespace wend {

/// Returns a part of a motion that moves its handle as a rigid body (a rotation, a curve with a frame, a
/// table of poses), from one time of it to another, plus a displacement times a factor that is linear in time
/// from `first` to `last`: a table of poses with screw interpolation between them. `place` is where the
/// handle is when the whole motion starts, without the displacement. Nothing for motions that change its size
/// or shape.
template <int Dim>
std::optional<Motion<Dim>> ledRigidly(const Motion<Dim>& motion, const MotionTime& part,
                                      const Vec<Dim>& place, const Vec<Dim>& by, double first, double last);

/// Returns where a handle is when such a motion starts that leads it to a place at a time; nothing for
/// others.
template <int Dim>
std::optional<Vec<Dim>> startOfRigid(const Motion<Dim>& motion, double time, const Vec<Dim>& place);

}  // namespace wend
