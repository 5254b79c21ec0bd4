#include "warp/convert.h"

#include <algorithm>

#include "warp/pixels.h"

namespace wend {
namespace {

/// Converts the colours of one pixel, associated or not, from the source's number of colours to the target's.
void placeColours(const float* in, int inColours, float* out, int outColours) {
    const bool spread = inColours < 3 && outColours >= 3;
    for (int c = 0; c < outColours; ++c) out[c] = in[spread ? 0 : std::min(c, inColours - 1)];
}

void convertPixel(const Image& source, const PixelLayout& layout, const float* in, float* out) {
    const int inColours = source.colours();
    const int outColours = layout.channels - (layout.alpha ? 1 : 0);
    const float alpha = source.alpha ? in[inColours] : 1.0f;
    placeColours(in, inColours, out, outColours);
    const bool associate = source.alpha && source.unassociated && !(layout.alpha && layout.unassociated);
    const bool separate = source.alpha && !source.unassociated && layout.alpha && layout.unassociated;
    for (int c = 0; c < outColours; ++c) {
        if (associate) out[c] *= alpha;
        if (separate && alpha > 0) out[c] /= alpha;
        if (source.alpha && !layout.alpha) out[c] += 1.0f - alpha;
    }
    if (layout.alpha) out[outColours] = alpha;
}

}  // namespace

PixelLayout layoutOf(const Image& image) {
    return {image.type, image.channels, image.alpha, image.unassociated};
}

void loadRow(const Image& image, int y, float* out) {
    withPixelType(image.type, [&](auto t) {
        using T = decltype(t);
        const T* in = reinterpret_cast<const T*>(image.row(y));
        for (int i = 0; i < image.width * image.channels; ++i) out[i] = static_cast<float>(in[i]) / kFull<T>;
    });
}

void storeRow(Image& image, int y, const float* in) {
    withPixelType(image.type, [&](auto t) {
        using T = decltype(t);
        T* out = reinterpret_cast<T*>(image.row(y));
        for (int i = 0; i < image.width * image.channels; ++i) out[i] = toPixel<T>(in[i] * kFull<T>);
    });
}

Image converted(const Image& image, const PixelLayout& layout) {
    if (layout == layoutOf(image)) return image;
    Image result;
    result.width = image.width, result.height = image.height, result.channels = layout.channels;
    result.type = layout.type, result.alpha = layout.alpha, result.unassociated = layout.unassociated;
    result.metadata = image.metadata;
    result.makePixels();
    const std::size_t width = static_cast<std::size_t>(image.width);
    std::vector<float> in(width * static_cast<std::size_t>(image.channels));
    std::vector<float> out(width * static_cast<std::size_t>(layout.channels));
    for (int y = 0; y < image.height; ++y) {
        loadRow(image, y, in.data());
        for (int x = 0; x < image.width; ++x)
            convertPixel(image, layout, in.data() + x * image.channels, out.data() + x * layout.channels);
        storeRow(result, y, out.data());
    }
    return result;
}

}  // namespace wend
