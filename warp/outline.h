#pragma once

#include "core/meshing/outline.h"
#include "warp/alpha_outline_options.h"
#include "warp/image.h"

namespace wend {

/// Returns the outline of the opaque parts by marching squares at sub-pixel accuracy, grown, without specks,
/// and simplified without crossings. Where the shape reaches the picture's border, the outline runs exactly
/// along the border; it never leaves the picture.
///
/// Growing does not join separate parts: where two parts or limbs (or the two sides of a hole) face each
/// other across less than 2 · margin + gap, the outline grows only until a gap of `gap` pixels is left; a
/// narrower one stays unchanged.
///
/// With `holes` filled, everything that an outline encloses belongs to the shape, as line art needs it.
///
/// Throws InputError for a picture without alpha, with nothing above the threshold, with nothing as large as
/// `smallest`, and for options out of range.
Outline outlineFromAlpha(const Image& image, const AlphaOutlineOptions& options = {});

/// Returns the whole picture's rectangle. Throws InputError unless both sizes are positive.
Outline frameOutline(int width, int height);

}  // namespace wend
