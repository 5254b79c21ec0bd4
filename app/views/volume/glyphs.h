#pragma once

#include "app/engine/motion/frame.h"
#include "app/engine/shape/pose_faults.h"
#include "app/views/volume/surface_renderer.h"

namespace wend {

DrawVertex drawVertex(const Vec3& p, const Vec3& normal, QRgb colour);

/// Returns arrows for the velocities of surface vertices; the longest is a tenth of the diagonal. At most a
/// thousand, evenly spread; scaled with the marks.
std::vector<DrawVertex> velocityArrows(const PosedFrame<3>& frame, const Points3& velocity,
                                       const CutSurface& surface, QRgb colour);

/// Returns ellipsoids for stiff cells: long along the stiff direction, which rotates with the material. On
/// the surface, for drawn cells whose B is not the identity.
std::vector<DrawVertex> stiffnessEllipsoids(const PosedFrame<3>& frame, const CutSurface& surface,
                                            QRgb colour);

/// Returns the triangles that cross and the faces of the cells that have blown up, a little outside, without
/// those with a corner that is `hidden`.
std::vector<DrawVertex> faultMarks(const PosedFrame<3>& frame, const PoseFaults<3>& faults,
                                   const std::function<bool(const Vec3&)>& hidden);

}  // namespace wend
