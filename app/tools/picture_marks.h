#pragma once

#include <QPainter>
#include <QSize>
#include <functional>
#include <vector>

#include "app/engine/motion/frame.h"
#include "app/tools/picture_shape_view.h"

namespace wend {

inline constexpr QRgb kBehind = 0xFFC8641E, kPlain = 0xFF5C5F69;

/// Draws hatches over parts in front (///) and behind (\\\), and a badge with the order of each connected
/// part. `depths`: per cell, or empty.
void paintDepths(QPainter& painter, const PosedFrame<2>& frame, const std::vector<float>& depths,
                 const std::function<QPointF(const Vec2&)>& toWidget);

/// Draws an ellipse in every stiff square of a screen grid: the longer, the stiffer along its axis. They
/// rotate with the shape.
void paintStiffnessMarks(QPainter& painter, PictureShapeView& view, const QSize& size);

/// Returns half of the long axis of a mark, in pixels.
double markLength(double ratio);

/// Draws arrows on a screen grid for the velocity at the shown time, relative to the largest one.
void paintVelocityArrows(QPainter& painter, PictureShapeView& view, const Points2& velocity,
                         const QSize& size);

}  // namespace wend
