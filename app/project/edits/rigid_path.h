#pragma once

#include <optional>
#include <vector>

#include "app/project/edits/key_edits.h"
#include "app/project/pin.h"

namespace wend {

/// Returns a part of a motion that moves its handle as a rigid body (a rotation, a curve with a frame, a
/// table of poses), from one time of it to another, plus a displacement times a factor that is linear in time
/// from `first` to `last`: a table of poses with screw interpolation between them. `place` is where the
/// handle is when the whole motion starts, without the displacement. Nothing for motions that change its size
/// or shape.
std::optional<PinMotion> ledRigidly(const PinMotion& motion, const MotionTime& part, const Vec3& place,
                                    const Vec3& by, double first, double last);

/// Returns where a handle is when such a motion starts that leads it to a place at a time; nothing for
/// others.
std::optional<Vec3> startOfRigid(const PinMotion& motion, double time, const Vec3& place);

/// Returns a rotation that is even in time, through a pose beside it at a time: two rotations about other
/// centres, by the same angles at the same times. In space one that is also shifted along its axis is a table
/// of two poses. None for other motions, and where a part turns by more than half a turn: an arc about
/// another centre would lead far away.
std::vector<PinMotion> ledRotation(const PinMotion& motion, const Vec3& by, double time);
/// Returns a rotation, with its easing, that begins and ends at poses beside its own; nothing for other
/// motions and for more than half a turn.
std::optional<PinMotion> turnedTo(const PinMotion& motion, const Vec3& first, const Vec3& last);
/// Returns one motion by what two do that follow each other, of which one at least rotates and the other
/// rotates or translates: a rotation where that is possible. Nothing for other motions, and where a whole
/// turn and a shift have no such motion.
std::optional<PinMotion> joinedRotations(const PinMotion& before, const PinMotion& after);

}  // namespace wend
