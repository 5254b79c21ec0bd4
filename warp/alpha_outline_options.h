#pragma once

namespace wend {

/// Selects what happens to the holes in opaque parts: they stay open, or belong to the shape with everything
/// in them.
enum class OutlineHoles { Kept, Filled };

/// How the outline of a picture's opaque parts is found (outlineFromAlpha()).
///
/// The defaults suit antialiased cut-outs: the contour of 10 % alpha is the foot of a soft edge, not its
/// middle, and a margin that is larger than `simplify` keeps what is fainter inside. So the outline runs
/// through fully transparent pixels around the shape, and the soft edge survives the warp whole.
struct AlphaOutlineOptions {
    double threshold = 0.1;  // of alpha (of full scale), in ]0, 1[
    double margin = 2;       // pixels that the outline is grown by, 0 … 100
    double gap = 2;          // pixels that growing leaves open between parts, limbs and across holes
    double smallest = 64;    // parts and holes of less area (pixels²) are dropped
    double simplify = 0.75;  // pixels that the simplified outline may deviate
    OutlineHoles holes = OutlineHoles::Kept;

    bool operator==(const AlphaOutlineOptions&) const = default;
};

}  // namespace wend
