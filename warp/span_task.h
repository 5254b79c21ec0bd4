#pragma once

#include <cstddef>
#include <vector>

#include "warp/cell_map.h"

namespace wend {

/// One level of a picture as the filters read it.
struct TexelLevel {
    const void* data = nullptr;
    int width = 0, height = 0;
    bool weighted = false;  // colours count by their alpha
    bool alpha = false;     // the last channel is alpha
};

/// A run of pixels of one row that one cell covers. The source of pixel x, in pixels of the level, is
///     p(x) = shrink · (a − (inRowX + gradientX · (a − anchor)), height − (inRowY + gradientY · (a −
///     anchor)))
/// with a = left + scale · (x + ½): every pixel's own, so that a window shows the bits of the whole.
struct SpanTask {
    TexelLevel level;
    double left = 0, scale = 1, height = 0;
    double anchor = 0, inRowX = 0, inRowY = 0, gradientX = 0, gradientY = 0, shrink = 1;
    float xx = 1, xy = 0, yy = 1;  // ellipse, see Ellipse
    float blend = 0;               // 0: bicubic only … 1: elliptical only
    int reachX = 2, reachY = 2;    // whole pixels within the ellipse's box
    bool inner = false;            // all pixels that may be read are in the picture
    bool isQuick = false;          // see WarpOptions
    bool addsAlpha = false;        // the output has a further channel, full
    int begin = 0, end = 0;

    void setCell(const CellMap& map, const CellFilter& filter) {
        anchor = map.anchor.x(), gradientX = map.gradient(0, 0), gradientY = map.gradient(1, 0);
        shrink = filter.shrink, blend = filter.blend;
        xx = filter.ellipse.xx, xy = filter.ellipse.xy, yy = filter.ellipse.yy;
        reachX = filter.ellipse.wholeReach.x(), reachY = filter.ellipse.wholeReach.y();
    }
    void setRow(const CellMap& map, double y) {
        const Vec2 inRow = map.inRow(y);
        height = y, inRowX = inRow.x(), inRowY = inRow.y();
    }
};

/// Pixels are rounded, from pixel `begin` on; a colour is that of pixel `begin` alone, four floats.
enum class SpanOutput { Pixels, Colour };
using PaintSpan = void (*)(const SpanTask&, SpanOutput, void* to);

/// Returns what paints spans of a picture of numbers of type T, on the SIMD target in use.
template <typename T>
PaintSpan spanPainterOf(int channels, Filter filter);

}  // namespace wend
