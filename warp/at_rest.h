#pragma once

#include "warp/warp_job.h"

namespace wend {

/// Returns whether the view shows the whole picture, pixel by pixel, on the undeformed shape.
bool isAtRest(const Image& source, const SimplicialMesh<2>& rest, const Points2& pose, const View& view);

/// Copies the source's own pixels into a strip where the shape is within `margin` pixels. An outline from
/// alpha leaves narrow gaps open, so that limbs come apart, and cuts soft edges that reach into the gaps;
/// undeformed places must not be cut.
void copyAtRest(const WarpJob& job, int margin, int top, Image& strip);

}  // namespace wend
