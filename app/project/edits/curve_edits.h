#pragma once

#include <optional>

#include "app/project/project_fwd.h"
#include "core/motion/handle.h"

namespace wend {

/// Returns the curve of a handle's last motion, or null if that is not a curve.
CurveMotion<3>* lastCurve(Design& design, int handle);
const CurveMotion<3>* lastCurve(const Design& design, int handle);

/// Returns whether the handle's last motion is a stroke or a translation.
bool canBecomeCurve(const Design& design, int handle);
/// Converts that motion to a Bézier curve through its ends, with its directions and bulge. `end` is the
/// handle's place after it. Returns nothing if it cannot be converted.
std::optional<Design> withCurve(const Design& design, int handle, const Vec3& end);

}  // namespace wend
