#include "app/view/canvas/screen_picture.h"

#include <cmath>

#include "warp/convert.h"
#include "warp/pixels.h"
#include "warp/warp.h"

namespace wend {

namespace {

constexpr PixelLayout kLayouts[] = {{PixelType::UInt8, 4, true, false}, {PixelType::UInt8, 4, true, true}};

/// NaN becomes black.
float clampedPart(float value) {
    return std::fmin(std::fmax(value, 0.0F), 1.0F);
}

/// Encodes scene-linear light (half and float files) as sRGB.
float encoded(float linear) {
    const float x = clampedPart(linear);
    return x <= 0.0031308F ? 12.92F * x : 1.055F * std::pow(x, 1 / 2.4F) - 0.055F;
}

/// Writes red, green, blue and alpha of a pixel in [0, 1], associated or not as in the source.
void putPixel(const Image& from, const float* pixel, std::uint8_t* to) {
    const bool linear = from.type == PixelType::Half || from.type == PixelType::Float;
    const int colours = from.colours();
    const float alpha = from.alpha ? clampedPart(pixel[colours]) : 1.0F;
    const float weight = from.unassociated || alpha <= 0 ? 1.0F : alpha;  // that the colours carry
    for (int c = 0; c < 3; ++c) {
        const float value = pixel[colours >= 3 ? c : 0] / weight;
        to[c] = toPixel<std::uint8_t>(255 * weight * (linear ? encoded(value) : clampedPart(value)));
    }
    to[3] = toPixel<std::uint8_t>(255 * alpha);
}

std::shared_ptr<const Image> forScreen(const std::shared_ptr<const Image>& from) {
    const PixelLayout& layout = kLayouts[from->unassociated || !from->alpha ? 1 : 0];
    if (layoutOf(*from) == layout) return from;
    auto to = std::make_shared<Image>(
        Image{from->width, from->height, 4, layout.type, true, layout.unassociated, {}, {}});
    to->makePixels();
    std::vector<float> row(static_cast<std::size_t>(from->width) * static_cast<std::size_t>(from->channels));
    for (int y = 0; y < from->height; ++y) {
        loadRow(*from, y, row.data());
        auto* out = reinterpret_cast<std::uint8_t*>(to->row(y));
        for (int x = 0; x < from->width; ++x)
            putPixel(*from, row.data() + static_cast<std::ptrdiff_t>(x) * from->channels, out + 4 * x);
    }
    return to;
}

/// Converts a result of forScreen().
QImage toQImage(const Image& pixels) {
    const auto format = pixels.unassociated ? QImage::Format_RGBA8888 : QImage::Format_RGBA8888_Premultiplied;
    const QImage borrowed(reinterpret_cast<const uchar*>(pixels.data.data()), pixels.width, pixels.height,
                          static_cast<qsizetype>(pixels.rowBytes()), format);
    return borrowed.convertToFormat(QImage::Format_ARGB32_Premultiplied);
}

}  // namespace

ScreenPicture::ScreenPicture(const std::shared_ptr<const Image>& picture) : m_pyramid(forScreen(picture)) {}

QImage ScreenPicture::warped(const SimplicialMesh<2>& rest, const Points<2>& pose, const View& view,
                             const WarpOptions& options) const {
    const Image pixels = warpImage(m_pyramid, rest, pose, view, options);
    return pixels.data.empty() ? QImage() : toQImage(pixels);
}

}  // namespace wend
