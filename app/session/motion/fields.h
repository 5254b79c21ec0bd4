#pragma once

#include "app/session/motion/frame.h"
#include "app/session/motion/frame_track.h"

namespace wend {

/// Of one cell. They have no use for a field but speedAt() and influenceOn(), for which nothing moves without
/// one; so all can stand in one table.
///
/// φ, and how many times stiffer the cell is along its stiffest direction than an isotropic one (the largest
/// eigenvalue of B₀).
template <int Dim>
double phiAt(const PosedFrame<Dim>& frame, const Points<Dim>& velocity, int cell);
template <int Dim>
double stiffnessAt(const PosedFrame<Dim>& frame, const Points<Dim>& velocity, int cell);
/// By how many degrees the right angle that changes most is no right angle any more: 0 where the shape only
/// moves, turns and grows, near 90 where it is squeezed flat.
template <int Dim>
double shearAt(const PosedFrame<Dim>& frame, const Points<Dim>& velocity, int cell);
/// How far its middle is from where it was at rest.
template <int Dim>
double wayAt(const PosedFrame<Dim>& frame, const Points<Dim>& velocity, int cell);
/// How far the selected handles take it along, in percent of their own way; what goes for a velocity here is
/// their influence (ShapeSession::influence).
template <int Dim>
double influenceOn(const PosedFrame<Dim>& frame, const Points<Dim>& influence, int cell);
/// How large it is at rest: the edge of a regular one of its area or volume.
template <int Dim>
double sizeAt(const PosedFrame<Dim>& frame, const Points<Dim>& velocity, int cell);
/// The length of the velocity in its middle.
template <int Dim>
double speedAt(const PosedFrame<Dim>& frame, const Points<Dim>& velocity, int cell);

/// About how the vertices move at the frame's time, per unit of time: the difference of its neighbours in the
/// track. Zero where nothing moves.
template <int Dim>
Points<Dim> velocityBetween(const FrameTrack& track, const PosedFrame<Dim>& frame);

}  // namespace wend
