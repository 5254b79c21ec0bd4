#pragma once

#include <QPainter>

#include "app/tools/tool_surface.h"

namespace wend {

/// Draws arrows on a screen grid for the velocity at the shown time, relative to the largest one.
void paintVelocityArrows(QPainter& painter, ToolSurface& surface, const Points<2>& velocity,
                         const QSize& size);

}  // namespace wend
