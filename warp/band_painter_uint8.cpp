#include "warp/band_painter.h"
#include "warp/span_targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "warp/band_painter_uint8.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "warp/span_filters_inl.h"

HWY_BEFORE_NAMESPACE();
namespace wend::HWY_NAMESPACE {

PaintSpan uint8Spans(int channels, Filter filter) {
    return spanPainter<std::uint8_t>(channels, filter);
}

}  // namespace wend::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace wend {
namespace {

HWY_EXPORT(uint8Spans);

}  // namespace

template <>
PaintSpan spanPainterOf<std::uint8_t>(int channels, Filter filter) {
    return HWY_DYNAMIC_DISPATCH(uint8Spans)(channels, filter);
}

template void paintBand<std::uint8_t>(const WarpJob&, int, BandPart, Image&, int);

}  // namespace wend
#endif
