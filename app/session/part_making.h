#pragma once

#include "core/meshing/outline.h"

namespace wend {

class ShapeSession;

/// Makes a part of what is in an area, in one undo step: it is cut out of the frontmost part that fills the
/// area, or of the whole picture, which is filled behind it, and welded where it hangs on the rest. A
/// photograph that fills its frame and has no pins is held. Says what has been made, or why it cannot be.
void makePart(ShapeSession& session, const Outline& area);

/// The same for what the user has drawn as the outline of a picture; the rest of the picture becomes the
/// ground. Returns false if nothing is drawn.
bool makePartOfOutline(ShapeSession& session);

}  // namespace wend
