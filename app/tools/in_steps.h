#pragma once

#include <QPointF>
#include <cmath>
#include <numbers>

namespace wend {

/// Projects a displacement on the nearest multiple of 45°.
inline QPointF inSteps(const QPointF& way) {
    constexpr double kStep = std::numbers::pi / 4;
    const double angle = kStep * std::round(std::atan2(way.y(), way.x()) / kStep);
    const QPointF along(std::cos(angle), std::sin(angle));
    return QPointF::dotProduct(way, along) * along;
}

}  // namespace wend
