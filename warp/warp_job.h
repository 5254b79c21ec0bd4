#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "warp/cell_map.h"
#include "warp/coverage.h"
#include "warp/outline_pixels.h"
#include "warp/pixels.h"

namespace wend {

inline constexpr int kBandRows = 32;

/// First pixel whose centre is at or after x.
inline int firstPixel(double x, int size) {
    const double bounded = std::clamp(x - 0.5, 0.0, static_cast<double>(size));
    const int whole = static_cast<int>(bounded);  // std::ceil is a call without SSE 4.1
    return whole + (whole < bounded ? 1 : 0);
}

/// A cell that the view may see.
struct VisibleCell {
    TriangleRows rows;
    CellMap map;
    CellFilter filter;
    Vec<2> low, high;  // corners of its box in the source
};

/// All that the bands of one warp share.
struct WarpJob {
    const Pyramid& source;
    const View& view;
    const WarpOptions& options;
    Image output;
    bool addsAlpha = false;
    std::vector<VisibleCell> cells;             // in painting order
    std::vector<std::vector<int>> cellsOfBand;  // places in `cells`
    OutlinePixels outline;                      // pixels that need coverage

    Vec<2> plane(double x, double y) const { return view.origin + view.scale * Vec<2>(x, y); }
};

/// Paints the rows of one band of a picture of numbers of type T.
template <typename T>
void paintBand(WarpJob& job, int band);

extern template void paintBand<std::uint8_t>(WarpJob&, int);
extern template void paintBand<std::uint16_t>(WarpJob&, int);
extern template void paintBand<half>(WarpJob&, int);
extern template void paintBand<float>(WarpJob&, int);

}  // namespace wend
