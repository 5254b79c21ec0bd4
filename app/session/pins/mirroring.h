#pragma once

#include "app/document/edits/mirror_edits.h"
#include "app/session/shape_session.h"

namespace wend {

/// Of a picture the upright line through its middle; of a solid the plane through its middle, across the
/// axis, in which it is most like its own mirror image (of several the first).
template <int Dim>
Mirror<Dim> mirrorOf(const SimplicialMesh<Dim>& rest);

/// For each selected pin one at its mirror image, with a mirrored motion; they are selected then. A notice
/// says where there is none.
void mirrorPins(ShapeSession& session);
/// The selected pins move as in a mirror that stands where they begin.
void mirrorMotion(ShapeSession& session);
/// True if a selected pin moves.
bool canMirrorMotion(const ShapeSession& session);

}  // namespace wend
