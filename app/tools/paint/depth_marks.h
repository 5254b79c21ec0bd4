#pragma once

#include <QPainter>
#include <functional>
#include <vector>

#include "app/engine/motion/frame.h"

namespace wend {

inline constexpr QRgb kBehind = 0xFFC8641E, kPlain = 0xFF5C5F69;

/// Draws hatches over parts in front (///) and behind (\\\), and a badge with the order of each connected
/// part. `depths`: per cell, or empty.
void paintDepths(QPainter& painter, const PosedFrame<2>& frame, const std::vector<float>& depths,
                 const std::function<QPointF(const Vec<2>&)>& toWidget);

}  // namespace wend
