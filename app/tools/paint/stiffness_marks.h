#pragma once

#include <QPainter>
#include <QSize>

#include "app/tools/tool_surface.h"

namespace wend {

/// Ellipses over a picture, one in every square of a grid on the screen where it is stiff: the longer, the
/// stiffer along that direction. They turn with the shape.
void paintStiffnessMarks(QPainter& painter, ToolSurface& surface, const QSize& size);

/// Half of the long axis of one, in pixels.
double markLength(double ratio);

}  // namespace wend
