#pragma once

#include "core/meshing/outline.h"

namespace wend {

/// Removes points as long as every removed one is within `tolerance` of the new edge. The topology of the
/// loops is preserved, because the simplification runs in a constrained triangulation of all of them (CGAL
/// Polyline_simplification_2).
Outline simplified(const Outline& outline, double tolerance);

}  // namespace wend
