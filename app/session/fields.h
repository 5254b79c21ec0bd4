#pragma once

#include "app/session/frame.h"
#include "app/session/frame_track.h"

namespace wend {

/// φ of every cell, and how many times stiffer it is along its stiffest direction than an isotropic one
/// (the largest eigenvalue of B₀).
template <int Dim>
std::vector<double> phiOf(const PosedFrame<Dim>& frame);
template <int Dim>
std::vector<double> stiffnessOf(const PosedFrame<Dim>& frame);

/// How large every cell is at rest: the edge of a regular one of its area or volume.
template <int Dim>
std::vector<double> sizesOf(const PosedFrame<Dim>& frame);

/// About how the vertices move at the frame's time, per unit of time: the difference of its neighbours in the
/// track. Zero where nothing moves.
template <int Dim>
Points<Dim> velocityBetween(const FrameTrack& track, const PosedFrame<Dim>& frame);
/// The length of the velocity in the middle of every cell.
template <int Dim>
std::vector<double> speedOf(const PosedFrame<Dim>& frame, const Points<Dim>& velocity);

}  // namespace wend
