#pragma once

#include <QPainter>
#include <QSize>

#include "app/tools/tool_surface.h"

namespace wend {

/// Draws an ellipse in every stiff square of a screen grid: the longer, the stiffer along its axis. They
/// rotate with the shape.
void paintStiffnessMarks(QPainter& painter, ToolSurface& surface, const QSize& size);

/// Half of the long axis of one, in pixels.
double markLength(double ratio);

}  // namespace wend
