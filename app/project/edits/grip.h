#pragma once

#include "app/project/pin.h"

namespace wend {

/// Amount of a gesture in up to three numbers, which the grip defines.
using Amount = Vec3;

/// How a gesture moves what it holds. Move: translate by the amount (without z in the plane). Turn: rotate by
/// amount[0] radians around the axis through the centre. Grow: scale by 1 + amount[0] from the centre.
struct Grip {
    enum class Kind { Move, Turn, Grow };
    Kind kind = Kind::Move;
    Vec3 centre = Vec3::Zero();
    Vec3 axis = Vec3::UnitZ();
};

/// Returns a point moved by the grip.
Vec3 carried(const Grip& grip, const Amount& amount, const Vec3& start);

/// Returns the motion from one amount to another, in the window [0, 1].
PinMotion motionBetween(const Grip& grip, const Amount& from, const Amount& to);

}  // namespace wend
