#include "warp/band_painter.h"

namespace wend {

template void paintBand<half>(WarpJob&, int);

}  // namespace wend
