#include "warp/band_painter.h"
#include "warp/span_targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "warp/band_painter_half.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "warp/span_filters_inl.h"

HWY_BEFORE_NAMESPACE();
namespace wend::HWY_NAMESPACE {

PaintSpan halfSpans(int channels, Filter filter) {
    return spanPainter<half>(channels, filter);
}

}  // namespace wend::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace wend {
namespace {

HWY_EXPORT(halfSpans);

}  // namespace

template <>
PaintSpan spanPainterOf<half>(int channels, Filter filter) {
    return HWY_DYNAMIC_DISPATCH(halfSpans)(channels, filter);
}

template void paintBand<half>(const WarpJob&, int, BandPart, Image&, int);

}  // namespace wend
#endif
