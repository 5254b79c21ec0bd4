#pragma once

#include <QPainter>

#include "app/tools/tool_surface.h"

namespace wend {

/// Arrows on a grid of the screen: where the shape goes at the time that is shown, and how fast against the
/// fastest part of it, whose arrow is the longest.
void paintVelocityArrows(QPainter& painter, ToolSurface& surface, const Points<2>& velocity,
                         const QSize& size);

}  // namespace wend
