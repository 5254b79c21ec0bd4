#include "warp/band_painter.h"

namespace wend {

template void paintBand<float>(WarpJob&, int);

}  // namespace wend
