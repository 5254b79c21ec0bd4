#pragma once

#include "app/session/shape_session.h"

namespace wend {

/// Whether there is a shape that has moved and may settle.
bool canSettle(const Document& document);
/// One undo step: a window of settling after all that moves, and the time goes to its end.
void settleAtEnd(ShapeSession& session);

}  // namespace wend
