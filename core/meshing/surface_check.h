#pragma once

#include <stop_token>

#include "core/meshing/surface.h"

namespace wend {

/// checkSurface, which of many large triangles on one spot takes long. Throws Cancelled.
SurfaceProblems checkSurface(const Surface& surface, int limit, const std::stop_token& stop);

}  // namespace wend
