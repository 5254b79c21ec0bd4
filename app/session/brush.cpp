#include "app/session/brush.h"

#include <algorithm>

namespace wend {

void Brush::set(const BrushSettings& settings) {
    BrushSettings next = settings;
    next.radius = std::clamp(next.radius, kSmallest, kLargest);
    next.hardness = std::clamp(next.hardness, 0.0, 1.0);
    if (next == m_now) return;
    m_now = next;
    emit changed();
}

}  // namespace wend
