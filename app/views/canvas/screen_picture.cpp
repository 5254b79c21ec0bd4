#include "app/views/canvas/screen_picture.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/style/theme.h"
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

/// Returns a table of the encoded light of every half, indexed by its bits.
const std::vector<std::uint8_t>& encodedHalves() {
    static const std::vector<std::uint8_t> table = [] {
        std::vector<std::uint8_t> values(std::size_t{1} << 16U);
        for (std::size_t bits = 0; bits < values.size(); ++bits) {
            half value;
            value.setBits(static_cast<std::uint16_t>(bits));
            values[bits] = toPixel<std::uint8_t>(255 * encoded(value));
        }
        return values;
    }();
    return table;
}

bool isLinear(const Image& image) {
    return image.type == PixelType::Half || image.type == PixelType::Float;
}

/// Writes red, green, blue and alpha of a pixel in [0, 1], associated or not as in the source.
void putPixel(const Image& from, const float* pixel, std::uint8_t* to) {
    const int colours = from.colours();
    for (int c = 0; c < 3; ++c) to[c] = toPixel<std::uint8_t>(255 * clampedPart(pixel[colours >= 3 ? c : 0]));
    to[3] = toPixel<std::uint8_t>(255 * (from.alpha ? clampedPart(pixel[colours]) : 1.0F));
}

/// Does the same for linear light, which may be brighter than white.
void putPixel(const Image& from, const float* pixel, half* to) {
    constexpr float kBrightest = 60000;
    const int colours = from.colours();
    for (int c = 0; c < 3; ++c)
        to[c] = std::fmin(std::fmax(pixel[colours >= 3 ? c : 0], -kBrightest), kBrightest);
    to[3] = from.alpha ? clampedPart(pixel[colours]) : 1.0F;
}

template <class Number>
void fillFrom(const Image& from, Image& to) {
    std::vector<float> row(static_cast<std::size_t>(from.width) * static_cast<std::size_t>(from.channels));
    for (int y = 0; y < from.height; ++y) {
        loadRow(from, y, row.data());
        auto* out = reinterpret_cast<Number*>(to.row(y));
        for (int x = 0; x < from.width; ++x)
            putPixel(from, row.data() + static_cast<std::ptrdiff_t>(x) * from.channels, out + 4 * x);
    }
}

std::shared_ptr<const Image> forScreen(const std::shared_ptr<const Image>& from) {
    PixelLayout layout = kLayouts[from->unassociated || !from->alpha ? 1 : 0];
    if (isLinear(*from)) layout.type = PixelType::Half;
    if (layoutOf(*from) == layout) return from;
    auto to = std::make_shared<Image>(
        Image{from->width, from->height, 4, layout.type, true, layout.unassociated, {}, {}});
    to->makePixels();
    isLinear(*from) ? fillFrom<half>(*from, *to) : fillFrom<std::uint8_t>(*from, *to);
    return to;
}

/// Encodes linear light: colours that are not multiplied with alpha.
QImage encodedImage(const Image& pixels) {
    const std::vector<std::uint8_t>& table = encodedHalves();
    QImage image(pixels.width, pixels.height, QImage::Format_RGBA8888);
    for (int y = 0; y < pixels.height; ++y) {
        const auto* from = reinterpret_cast<const half*>(pixels.row(y));
        uchar* to = image.scanLine(y);
        for (int x = 0; x < pixels.width; ++x, from += 4, to += 4) {
            const float alpha = clampedPart(from[3]);
            const bool isWhole = pixels.unassociated || alpha <= 0 || alpha >= 1;
            for (int c = 0; c < 3; ++c)
                to[c] = table[isWhole ? from[c].bits() : half(static_cast<float>(from[c]) / alpha).bits()];
            to[3] = toPixel<std::uint8_t>(255 * alpha);
        }
    }
    return image.convertToFormat(QImage::Format_ARGB32_Premultiplied);
}

/// Computes the lightness from a small level, whose pixels average those of the picture.
double meanLightness(const Pyramid& pyramid) {
    constexpr int kEnough = 128;  // pixels a side
    int small = 0;
    while (small + 1 < pyramid.levels() &&
           std::max(pyramid.level(small + 1).width, pyramid.level(small + 1).height) >= kEnough)
        ++small;
    const Image& image = pyramid.level(small);
    if (isLinear(image)) return lightnessOf(encodedImage(image));
    return lightnessOf(
        QImage(reinterpret_cast<const uchar*>(image.row(0)), image.width, image.height, 4 * image.width,
               image.unassociated ? QImage::Format_RGBA8888 : QImage::Format_RGBA8888_Premultiplied));
}

QRgb withRedAndBlueSwapped(QRgb pixel) {
    return (pixel & 0xFF00FF00U) | (pixel & 0xFFU) << 16U | (pixel >> 16U & 0xFFU);
}

/// Converts `count` pixels of four bytes, red first, in place.
template <class Count>
void toArgb(bool unassociated, QRgb* pixels, Count count) {
    QRgb all = ~QRgb(0), any = 0;
    for (int k = 0; k < count; ++k) all &= pixels[k], any |= pixels[k];
    for (int k = 0; k < count; ++k) pixels[k] = withRedAndBlueSwapped(pixels[k]);
    if (unassociated && qAlpha(all) != 255 && any != 0)
        for (int k = 0; k < count; ++k) pixels[k] = qPremultiply(pixels[k]);
}

/// Does the same in blocks of a constant number of pixels, which the compiler can vectorize.
void toArgb(bool unassociated, QRgb* begin, QRgb* end) {
    constexpr int kBlock = 16;
    for (; end - begin >= kBlock; begin += kBlock)
        toArgb(unassociated, begin, std::integral_constant<int, kBlock>());
    toArgb(unassociated, begin, static_cast<int>(end - begin));
}

/// Takes over pixels that are Qt's, and converts others.
QImage toQImage(Image&& pixels) {
    if (pixels.type == PixelType::Half) return encodedImage(pixels);
    auto* owned = new Image(std::move(pixels));
    return QImage(
        reinterpret_cast<uchar*>(owned->data.data()), owned->width, owned->height,
        static_cast<qsizetype>(owned->rowBytes()), QImage::Format_ARGB32_Premultiplied,
        [](void* image) { delete static_cast<Image*>(image); }, owned);
}

}  // namespace

ScreenPicture::ScreenPicture(const std::shared_ptr<const Image>& picture)
    : m_pyramid(forScreen(picture)), m_lightness(meanLightness(m_pyramid)) {}

QImage ScreenPicture::warped(const SimplicialMesh<2>& rest, const Points2& pose, const View& view,
                             const WarpOptions& options) const {
    WarpOptions own = options;
    if (image().type == PixelType::UInt8)
        own.finishRows = [unassociated = image().unassociated, width = view.width](std::byte* first,
                                                                                   int rows) {
            auto* const begin = reinterpret_cast<QRgb*>(first);
            toArgb(unassociated, begin, begin + static_cast<std::ptrdiff_t>(rows) * width);
        };
    Image pixels = warpImage(m_pyramid, rest, pose, view, own);
    return pixels.data.empty() ? QImage() : toQImage(std::move(pixels));
}

}  // namespace wend
