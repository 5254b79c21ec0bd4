#pragma once

#include "core/motion/handle.h"

namespace wend {

/// Amount of a gesture in up to three numbers, which the grip defines.
using Amount = Vec<3>;

/// How a gesture moves what it holds. Move: translate by the amount (without z in the plane). Turn: rotate by
/// amount[0] radians around the axis through the centre. Grow: scale by 1 + amount[0] from the centre.
struct Grip {
    enum class Kind { Move, Turn, Grow };
    Kind kind = Kind::Move;
    Vec<3> centre = Vec<3>::Zero();
    Vec<3> axis = Vec<3>::UnitZ();
};

template <int Dim>
Amount amountOf(const Vec<Dim>& offset) {
    Amount amount = Amount::Zero();
    amount.template head<Dim>() = offset;
    return amount;
}

/// Returns a point moved by the grip.
template <int Dim>
Vec<Dim> carried(const Grip& grip, const Amount& amount, const Vec<Dim>& start);

/// Returns the motion from one amount to another, in the window [0, 1].
template <int Dim>
Motion<Dim> motionBetween(const Grip& grip, const Amount& from, const Amount& to);

}  // namespace wend
