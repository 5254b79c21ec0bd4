#pragma once

#include "app/engine/motion/frame.h"
#include "app/engine/motion/frame_track.h"

namespace wend {

/// Return values of one cell. Only speedAt() and influenceOn() use the field; the others take it so that all
/// fit in one table. phiAt() returns φ, and the stiffness relative to an isotropic cell is the largest
/// eigenvalue of B₀.
template <int Dim>
double phiAt(const PosedFrame<Dim>& frame, const Points<Dim>& velocity, int cell);
template <int Dim>
double stiffnessAt(const PosedFrame<Dim>& frame, const Points<Dim>& velocity, int cell);
/// Returns the largest change of a right angle in degrees: 0 for similarities, near 90 for degenerate cells.
template <int Dim>
double shearAt(const PosedFrame<Dim>& frame, const Points<Dim>& velocity, int cell);
/// Returns the distance of the cell's centroid from its rest position.
template <int Dim>
double wayAt(const PosedFrame<Dim>& frame, const Points<Dim>& velocity, int cell);
/// Returns the motion of the cell in percent of the motion of the selected handles. The field is their
/// influence here (ShapeMotion::influence).
template <int Dim>
double influenceOn(const PosedFrame<Dim>& frame, const Points<Dim>& influence, int cell);
/// Returns the edge length of a regular cell of the same rest area or volume.
template <int Dim>
double sizeAt(const PosedFrame<Dim>& frame, const Points<Dim>& velocity, int cell);
/// Returns the length of the velocity in the middle of a cell.
template <int Dim>
double speedAt(const PosedFrame<Dim>& frame, const Points<Dim>& velocity, int cell);

/// Returns approximate vertex velocities at the frame's time: the finite difference of its neighbours in the
/// track. Zero where nothing moves.
template <int Dim>
Points<Dim> velocityBetween(const FrameTrack& track, const PosedFrame<Dim>& frame);

}  // namespace wend
