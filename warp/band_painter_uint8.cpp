#include "warp/band_painter.h"

namespace wend {

template void paintBand<std::uint8_t>(const WarpJob&, int, BandPart, Image&, int);

}  // namespace wend
