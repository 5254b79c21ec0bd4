#pragma once

#include "app/engine/motion/playback.h"
#include "app/project/edits/document.h"

namespace wend {

/// Returns whether there is a moved shape that can relax. An elastic one is relaxed at all times.
bool canSettle(const Document& document);
/// Appends a relaxation to the motion in one undo step and moves the time to its end.
void settleAtEnd(Document& document, Playback& playback);

}  // namespace wend
