#include "app/session/brush.h"

#include <algorithm>

namespace wend {

BrushSettings bounded(BrushSettings brush) {
    brush.radius = std::clamp(brush.radius, Brush::kSmallest, Brush::kLargest);
    brush.hardness = std::clamp(brush.hardness, 0.0, 1.0);
    return brush;
}

}  // namespace wend
