#pragma once

#include <optional>

#include "app/project/project_fwd.h"
#include "core/motion/handle.h"

namespace wend {

/// Returns the curve of a handle's last motion, or null if that is not a curve.
template <int Dim>
CurveMotion<Dim>* lastCurve(Design<Dim>& design, int handle);
template <int Dim>
const CurveMotion<Dim>* lastCurve(const Design<Dim>& design, int handle);

/// Returns whether the handle's last motion is a stroke or a translation.
template <int Dim>
bool canBecomeCurve(const Design<Dim>& design, int handle);
/// Converts that motion to a Bézier curve through its ends, with its directions and bulge. `end` is the
/// handle's place after it. Returns nothing if it cannot be converted.
template <int Dim>
std::optional<Design<Dim>> withCurve(const Design<Dim>& design, int handle, const Vec<Dim>& end);

}  // namespace wend
