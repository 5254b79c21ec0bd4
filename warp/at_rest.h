#pragma once

#include "warp/warp_job.h"

namespace wend {

/// Whether the view shows the whole picture, pixel by pixel, on the shape at rest: nothing has moved.
bool isAtRest(const Image& source, const SimplicialMesh<2>& rest, const Points<2>& pose, const View& view);

/// Copies the source's own pixels into a strip wherever one within `margin` pixels is the shape's. An outline
/// around what is opaque leaves narrow gaps open, so that limbs come apart; their soft edges reach into the
/// gaps and are cut there. Where nothing has moved nothing must be.
void copyAtRest(const WarpJob& job, int margin, int top, Image& strip);

}  // namespace wend
