#include "app/tools/outline_settings.h"

#include <algorithm>

namespace wend {

void OutlinePen::set(const OutlineSettings& settings) {
    OutlineSettings next = settings;
    next.radius = std::clamp(next.radius, kSmallest, kLargest);
    next.tolerance = std::clamp(next.tolerance, 0.0, 1.0);
    if (next == m_now) return;
    m_now = next;
    emit changed();
}

}  // namespace wend
