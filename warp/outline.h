#pragma once

#include "core/meshing/outline.h"
#include "warp/image.h"

namespace wend {

/// The defaults suit antialiased cut-outs: the contour of 10 % alpha is the foot of a soft edge, not its
/// middle, and a margin that is larger than `simplify` keeps what is fainter inside. So the outline runs
/// through fully transparent pixels around the shape, and the soft edge survives the warp whole.
struct AlphaOutlineOptions {
    double threshold = 0.1;  // of alpha (of full scale), in ]0, 1[
    double margin = 2;       // pixels that the outline is grown by, 0 … 100
    double gap = 2;          // pixels that growing leaves open between parts, limbs and across holes
    double smallest = 64;    // parts and holes of less area (pixels²) are dropped
    double simplify = 0.75;  // pixels that the simplified outline may deviate
};

/// The outline of the opaque parts by marching squares at sub-pixel accuracy, grown, specks dropped,
/// simplified without crossings. Where the shape reaches the picture's border, the outline runs exactly along
/// the border; it never leaves the picture.
///
/// Growing does not join what is apart: where two parts or limbs (or the two sides of a hole) face each other
/// across less than 2 · margin + gap, the outline grows only until a gap of `gap` pixels is left; a narrower
/// one is left as it is.
///
/// Throws InputError for a picture without alpha, with nothing above the threshold, with nothing as large as
/// `smallest`, and for options out of range.
Outline outlineFromAlpha(const Image& image, const AlphaOutlineOptions& options = {});

/// The whole picture's rectangle. Throws InputError unless both sizes are positive.
Outline frameOutline(int width, int height);

}  // namespace wend
