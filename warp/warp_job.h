#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "warp/cell_map.h"
#include "warp/coverage.h"
#include "warp/outline_pixels.h"
#include "warp/pixels.h"

namespace wend {

inline constexpr int kBandRows = 32;

/// Returns the first pixel whose centre is at or after x.
inline int firstPixel(double x, int size) {
    const double bounded = std::clamp(x - 0.5, 0.0, static_cast<double>(size));
    const int whole = static_cast<int>(bounded);  // std::ceil is a call without SSE 4.1
    return whole + (whole < bounded ? 1 : 0);
}

/// Calls visit(y, from, to) for the runs of pixels, in the rows from `begin` to before `end` of a picture of
/// that width, whose centres the triangle covers.
template <typename Visit>
void forRuns(const TriangleRows& rows, int begin, int end, int width, Visit&& visit) {
    for (int y = std::max(begin, firstPixel(rows.top(), end)); y < end && y + 0.5 < rows.bottom(); ++y) {
        const Span span = rows.at(y + 0.5);
        const int from = firstPixel(span.begin, width), to = firstPixel(span.end, width);
        if (from < to) visit(y, from, to);
    }
}

/// A cell that the view may see.
struct VisibleCell {
    TriangleRows rows;
    CellMap map;
    CellFilter filter;
    Vec2 low, high;  // corners of its box in the source
    int part = 0;    // of the mesh, where parts are blended
    BlendMode blend = BlendMode::Normal;
};

/// All that the bands of one warp share.
struct WarpJob {
    View view;
    WarpOptions options;
    Image header;  // of the output: no pixels
    bool addsAlpha = false;
    bool atRest = false;  // nothing has moved, and options.restMargin counts
    const Pyramid* source = nullptr;
    CellFilter outsideFilter;
    std::vector<VisibleCell> cells;             // in painting order
    std::vector<std::vector<int>> cellsOfBand;  // places in `cells`
    OutlinePixels outline;                      // pixels that need coverage

    int bands() const { return static_cast<int>(cellsOfBand.size()); }
    Vec2 plane(double x, double y) const { return view.origin + view.scale * Vec2(x, y); }
};

/// Selects what of a band is painted: all, or everything but the cells.
enum class BandPart { All, BesideCells };

/// Paints the rows of one band of a picture of numbers of type T. `strip` has the output's width and layout,
/// is zero but for cells that are painted already, and its first row is row `top` of the output.
template <typename T>
void paintBand(const WarpJob& job, int band, BandPart part, Image& strip, int top);

extern template void paintBand<std::uint8_t>(const WarpJob&, int, BandPart, Image&, int);
extern template void paintBand<std::uint16_t>(const WarpJob&, int, BandPart, Image&, int);
extern template void paintBand<half>(const WarpJob&, int, BandPart, Image&, int);
extern template void paintBand<float>(const WarpJob&, int, BandPart, Image&, int);

}  // namespace wend
