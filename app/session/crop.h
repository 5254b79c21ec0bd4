#pragma once

#include "app/base/shared_value.h"
#include "app/project/pixel_rect.h"

namespace wend {

inline std::optional<PixelRect> bounded(std::optional<PixelRect> part) {
    return part;
}

/// The part of a picture that exports keep, drawn by the user; nothing means all of it. It belongs to the
/// window, not to the document.
using Crop = SharedValue<std::optional<PixelRect>>;

}  // namespace wend
