#pragma once

#include <array>
#include <functional>
#include <memory>
#include <stop_token>
#include <vector>

#include "core/mesh/simplicial_mesh.h"
#include "warp/blend_mode.h"
#include "warp/cell_painter.h"
#include "warp/image.h"
#include "warp/pyramid.h"
#include "warp/sampling.h"

namespace wend {

struct PaintingPlan;  // warp/coverage.h

struct WarpOptions {
    Filter filter = Filter::Ewa;
    /// For a picture that moves: bilinear colours of RGBA with 8 bits may be off by a fortieth of a level
    /// before they are rounded, and depend on where the view begins.
    bool isQuick = false;
    Outside outside = Outside::Transparent;
    std::array<float, 4> colour = {0, 0, 0, 0};  // of Outside::Colour, associated, in [0, 1]
    bool antialias = true;                       // coverage along the outline
    /// The depth per cell: greater is nearer, and between whole numbers there is an outline. If depths are
    /// equal, or empty, later cells are in front of earlier ones. Transparent pixels of a cell show those
    /// below it.
    std::vector<float> depth;
    /// How each part of the mesh (SimplicialMesh::parts) is combined with what is below it; empty: all are
    /// normal.
    std::vector<BlendMode> blends;
    /// The plan of the mesh and that depth, made before, for a window that draws one pose after another; or
    /// null.
    std::shared_ptr<const PaintingPlan> plan;
    /// Pixels that are no farther than this from the shape are the source's own, to the bit, if nothing has
    /// moved: for an outline that leaves gaps open between soft edges. With 0 the outline cuts them.
    int restMargin = 0;
    /// The size of the picture that the view is a part of; 0: that of the source.
    int frameWidth = 0, frameHeight = 0;
    int threads = 0;
    MakeCellPainter makePainter;
    std::stop_token stop;
    std::function<void(double)> progress;  // fraction done; called from any thread
    /// Called with rows of the result when they are painted, from any thread: their first byte and their
    /// number. It may change them.
    std::function<void(std::byte*, int)> finishRows;
};

/// Returns the place of a view in its source of that size, if that can be expressed in whole pixels;
/// otherwise, and for all of the source, a frame of its own.
CanvasPlace placeOf(const View& view, int sourceWidth, int sourceHeight);

/// Returns the picture carried by the map rest → pose: every output pixel looks up the source through the
/// inverse affine map of the cell that covers it. Output has the type, channels (plus alpha if needed) and
/// metadata of `source`. `rest` is in pixels of `source` (centres at +0.5); the same rest may be given scaled
/// for another size of the picture.
Image warpImage(const Image& source, const SimplicialMesh<2>& rest, const Points2& pose, const View& view,
                const WarpOptions& options = {});

/// Does the same with a given pyramid of the picture, for a window that draws it again and again.
Image warpImage(const Pyramid& source, const SimplicialMesh<2>& rest, const Points2& pose, const View& view,
                const WarpOptions& options = {});

/// Returns an ST map, float RGBA: R = source x / width, G = source y / height from the bottom (the
/// compositing convention), B = 0, A = coverage. Where cells overlap, the map has the nearest one; `depth` as
/// in WarpOptions. `inverse` swaps the roles of rest and pose.
Image stMap(const SimplicialMesh<2>& rest, const Points2& pose, const View& view, int sourceWidth,
            int sourceHeight, const std::vector<float>& depth = {}, bool inverse = false);

}  // namespace wend
