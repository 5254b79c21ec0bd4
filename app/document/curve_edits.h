#pragma once

#include <optional>

#include "app/document/project_fwd.h"
#include "core/motion/handle.h"

namespace wend {

/// The curve that a handle follows at the end, if its last motion is one that goes anywhere; null otherwise.
template <int Dim = 3>
CurveMotion<Dim>* lastCurve(Project& project, int handle);
template <int Dim = 3>
const CurveMotion<Dim>* lastCurve(const Project& project, int handle);

/// True if the last motion of the handle is a stroke or a translation.
template <int Dim = 3>
bool canBecomeCurve(const Project& project, int handle);
/// That motion as a Bézier curve through its ends, with the directions and the sway that it had. `end` is
/// where the handle is after it. Nothing if it cannot become one.
template <int Dim = 3>
std::optional<Project> withCurve(const Project& project, int handle, const Vec<Dim>& end);

}  // namespace wend
