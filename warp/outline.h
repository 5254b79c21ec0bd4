#pragma once

#include "core/meshing/outline.h"
#include "warp/image.h"

namespace wend {

struct AlphaOutlineOptions {
    double threshold = 0.5;  // of alpha, in ]0, 1[
    double margin = 2;       // pixels that the outline is grown by
    double smallest = 64;    // parts and holes of less area (pixels²) are dropped
    double simplify = 0.75;  // pixels that the simplified outline may deviate
};

/// The outline of the opaque parts by marching squares at sub-pixel accuracy, grown, specks dropped,
/// simplified without crossings. Throws InputError for a picture without alpha or with nothing above the
/// threshold.
Outline outlineFromAlpha(const Image& image, const AlphaOutlineOptions& options = {});

/// The whole picture's rectangle.
Outline frameOutline(int width, int height);

}  // namespace wend
