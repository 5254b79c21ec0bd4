#pragma once

#include <memory>
#include <vector>

#include "core/base/types.h"
#include "warp/blend_mode.h"
#include "warp/image.h"

namespace wend {

/// A picture among others over one another, with its first pixel at `at`.
struct Sheet {
    std::shared_ptr<const Image> picture;
    Vec2 at = Vec2::Zero();
    double opacity = 1;
    bool hidden = false;
    BlendMode blend = BlendMode::Normal;

    double shownOpacity() const { return hidden ? 0 : opacity; }
    bool operator==(const Sheet&) const = default;
};

/// Several pictures side by side in one, each with its opacity, and surrounded by copies of its border for
/// filters that reach beyond it.
struct Atlas {
    Image picture;
    std::vector<Vec2> places;  // of the first pixel of each
};

/// Returns the atlas of some sheets. It has alpha, and the type and channels that hold every picture; its
/// profile, and whether colours are associated, are those of the first. Throws InputError for more than
/// kMaxMegapixels.
Atlas makeAtlas(const std::vector<Sheet>& sheets);

/// Returns the sheets over one another, the first one on top, on a canvas of that size, as blendedColour()
/// says. Sheets are placed at whole pixels.
Image flattened(const std::vector<Sheet>& sheets, int width, int height);

/// Multiplies the opacity of every pixel; `factor` gives as many factors as the row has pixels, in [0, 1].
/// The picture gets alpha if it has none.
Image faded(const Image& image, const std::function<void(int y, std::vector<float>& factors)>& factor);

}  // namespace wend
