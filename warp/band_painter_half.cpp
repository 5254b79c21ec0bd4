#include "warp/band_painter.h"

namespace wend {

template void paintBand<half>(const WarpJob&, int, BandPart, Image&, int);

}  // namespace wend
