#pragma once

#include "app/session/shape_session.h"

namespace wend {

/// Returns whether the last path of the single selected handle can become a Bézier curve.
bool canMakeCurve(const ShapeSession& session);
/// Makes it one; one undo step.
void makeCurve(ShapeSession& session);

}  // namespace wend
