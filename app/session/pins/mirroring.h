#pragma once

#include "app/project/edits/mirror_edits.h"
#include "app/session/shape_session.h"

namespace wend {

/// Returns the mirror of a shape: for pictures the vertical line through the middle, for solids the
/// axis-aligned plane through the middle that makes it most similar to its mirror image (the first of
/// equals).
Mirror mirrorOf(const ShapeFrame& frame);

/// Returns for each handle the one that is nearest to its mirror image, which may be itself; itself if none
/// is near.
std::vector<int> mirrorImages(const ShapeFrame& frame, const std::vector<Pin>& handles);

/// Adds and selects a mirrored pin with a mirrored motion for each selected pin. Emits a notice where that is
/// impossible.
void mirrorPins(ShapeSession& session);
/// Mirrors the motion of the selected pins at their start.
void mirrorMotion(ShapeSession& session);
/// Returns whether a selected pin moves.
bool canMirrorMotion(const ShapeSession& session);

}  // namespace wend
