#pragma once

#include <optional>

#include "app/document/project_fwd.h"
#include "core/motion/handle.h"

namespace wend {

/// The curve that a handle follows at the end, if its last motion is one that goes anywhere; null otherwise.
template <int Dim>
CurveMotion<Dim>* lastCurve(Design<Dim>& design, int handle);
template <int Dim>
const CurveMotion<Dim>* lastCurve(const Design<Dim>& design, int handle);

/// True if the last motion of the handle is a stroke or a translation.
template <int Dim>
bool canBecomeCurve(const Design<Dim>& design, int handle);
/// That motion as a Bézier curve through its ends, with the directions and the sway that it had. `end` is
/// where the handle is after it. Nothing if it cannot become one.
template <int Dim>
std::optional<Design<Dim>> withCurve(const Design<Dim>& design, int handle, const Vec<Dim>& end);

}  // namespace wend
