#pragma once

#include <string>

#include "app/base/shared_value.h"

namespace wend {

/// Selects what a drawn area does; Ctrl exchanges the first two.
enum class OutlineUse { Add, TakeAway, MakePart };

/// Settings shared by the outline tools.
struct OutlineSettings {
    OutlineUse use = OutlineUse::Add;
    double radius = 22;       // of the brush, in pixels of the screen
    double tolerance = 0.12;  // of colours, of full scale
    std::string part = {};    // whose outline is drawn; empty: of none, or of a picture without parts
    bool operator==(const OutlineSettings&) const = default;
};

OutlineSettings bounded(OutlineSettings pen);

/// The settings that all outline tools share.
class OutlinePen : public SharedValue<OutlineSettings> {
  public:
    static constexpr double kSmallest = 3, kLargest = 300;  // radius
    using SharedValue::SharedValue;
};

}  // namespace wend
