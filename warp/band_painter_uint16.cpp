#include "warp/band_painter.h"

namespace wend {

template void paintBand<std::uint16_t>(WarpJob&, int);

}  // namespace wend
