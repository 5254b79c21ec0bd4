#pragma once

#include <QPainter>

#include "app/tools/picture_shape_view.h"

namespace wend {

/// Draws arrows on a screen grid for the velocity at the shown time, relative to the largest one.
void paintVelocityArrows(QPainter& painter, PictureShapeView& view, const Points<2>& velocity,
                         const QSize& size);

}  // namespace wend
