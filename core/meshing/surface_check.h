#pragma once

#include <stop_token>

#include "core/meshing/surface.h"

namespace wend {

/// Does what the other checkSurface does; this takes long for many large triangles at one place. Throws
/// Cancelled.
SurfaceProblems checkSurface(const Surface& surface, int limit, const std::stop_token& stop);

}  // namespace wend
