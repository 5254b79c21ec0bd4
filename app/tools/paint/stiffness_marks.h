#pragma once

#include <QPainter>
#include <QSize>

#include "app/tools/picture_shape_view.h"

namespace wend {

/// Draws an ellipse in every stiff square of a screen grid: the longer, the stiffer along its axis. They
/// rotate with the shape.
void paintStiffnessMarks(QPainter& painter, PictureShapeView& view, const QSize& size);

/// Returns half of the long axis of a mark, in pixels.
double markLength(double ratio);

}  // namespace wend
