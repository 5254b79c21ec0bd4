#pragma once

#include "app/engine/shape/pose_faults.h"
#include "app/views/volume/glyphs.h"

namespace wend {

/// The triangles that cross and the faces of the cells that have blown up, a little outside, but for those
/// with a corner that is `hidden`.
std::vector<DrawVertex> faultMarks(const PosedFrame<3>& frame, const PoseFaults<3>& faults,
                                   const std::function<bool(const Vec<3>&)>& hidden);

}  // namespace wend
