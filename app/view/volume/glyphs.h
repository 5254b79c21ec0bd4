#pragma once

#include "app/session/motion/frame.h"
#include "app/view/volume/surface_renderer.h"

namespace wend {

DrawVertex drawVertex(const Vec<3>& p, const Vec<3>& normal, QRgb colour);

/// Arrows that show where the vertices of the surface go: the longest is a tenth of the diagonal. At most a
/// thousand, spread evenly over the vertices; in the size of the marks.
std::vector<DrawVertex> velocityArrows(const PosedFrame<3>& frame, const Points<3>& velocity,
                                       const CutSurface& surface, QRgb colour);

/// Ellipsoids that show where the material is stiff: long along the stiff direction, which turns with the
/// material. On the surface, for cells that are drawn and whose B is not the identity.
std::vector<DrawVertex> stiffnessEllipsoids(const PosedFrame<3>& frame, const CutSurface& surface,
                                            QRgb colour);

}  // namespace wend
