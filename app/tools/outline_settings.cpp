#include "app/tools/outline_settings.h"

#include <algorithm>

namespace wend {

OutlineSettings bounded(OutlineSettings pen) {
    pen.radius = std::clamp(pen.radius, OutlinePen::kSmallest, OutlinePen::kLargest);
    pen.tolerance = std::clamp(pen.tolerance, 0.0, 1.0);
    return pen;
}

}  // namespace wend
