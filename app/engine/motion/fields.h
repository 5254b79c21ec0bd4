#pragma once

#include <vector>

#include "app/engine/measure.h"
#include "app/engine/motion/frame.h"
#include "app/engine/motion/frame_track.h"

namespace wend {

/// Return the value of a measure in one cell or in all: the errors of docs/method.md for angle and length,
/// the ratio det F for area, the largest eigenvalue of B₀ for stiffness (1 where the cell is isotropic), the
/// edge length of a regular cell of the same rest area or volume for cell size, degrees for shear and the
/// smallest angle. `field` has a column per vertex: velocities for Speed; for Influence the influence of the
/// selected handles (ShapeMotion::influence), in percent of whose motion the value is. Without columns both
/// are 0.
double cellValue(const ShapeFrame& frame, Measure measure, int cell, const Eigen::MatrixXd& field = {});
std::vector<double> cellValues(const ShapeFrame& frame, Measure measure, const Eigen::MatrixXd& field = {});

/// Returns approximate vertex velocities at the frame's time, a column each: the finite difference of its
/// neighbours in the track. Zero where nothing moves.
Eigen::MatrixXd velocityBetween(const FrameTrack& track, const ShapeFrame& frame);

}  // namespace wend
