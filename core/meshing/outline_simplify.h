#pragma once

#include "core/meshing/outline.h"

namespace wend {

/// Removes points as long as no removed one is farther than `tolerance` from the new edge. Loops keep apart:
/// the simplification runs in a constrained triangulation of all of them (CGAL Polyline_simplification_2) and
/// never changes how they lie to each other.
Outline simplified(const Outline& outline, double tolerance);

}  // namespace wend
