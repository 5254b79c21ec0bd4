#include "app/view/screen_picture.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstring>

namespace wend {

namespace {

/// Scene-linear light (half and float files) as the screen wants it.
float encoded(float linear) {
    const float x = std::clamp(linear, 0.0F, 1.0F);
    return x <= 0.0031308F ? 12.92F * x : 1.055F * std::pow(x, 1 / 2.4F) - 0.055F;
}

float component(const std::byte* p, PixelType type, int channel) {
    switch (type) {
        case PixelType::UInt8:
            return static_cast<float>(std::to_integer<int>(p[channel])) / 255.0F;
        case PixelType::UInt16: {
            std::uint16_t v = 0;
            std::memcpy(&v, p + 2 * channel, 2);
            return static_cast<float>(v) / 65535.0F;
        }
        case PixelType::Half: {
            Eigen::half v;
            std::memcpy(&v, p + 2 * channel, 2);
            return static_cast<float>(v);
        }
        case PixelType::Float:
            break;
    }
    float v = 0;
    std::memcpy(&v, p + 4 * channel, 4);
    return v;
}

/// Red, green, blue and alpha in 8 bits, as associated as they were.
void convertPixel(const Image& from, const std::byte* p, std::uint8_t* to) {
    const bool linear = from.type == PixelType::Half || from.type == PixelType::Float;
    const int colours = from.channels - (from.alpha ? 1 : 0);
    const float alpha =
        from.alpha ? std::clamp(component(p, from.type, from.channels - 1), 0.0F, 1.0F) : 1.0F;
    const float weight = from.unassociated || alpha <= 0 ? 1.0F : alpha;  // that the colours carry
    for (int c = 0; c < 3; ++c) {
        const float value = component(p, from.type, colours >= 3 ? c : 0) / weight;
        const float shown = weight * std::clamp(linear ? encoded(value) : value, 0.0F, 1.0F);
        to[c] = static_cast<std::uint8_t>(std::lround(255 * shown));
    }
    to[3] = static_cast<std::uint8_t>(std::lround(255 * alpha));
}

Image converted(const Image& from) {
    Image to;
    to.width = from.width;
    to.height = from.height;
    to.channels = 4;
    to.alpha = true;
    to.unassociated = from.unassociated || !from.alpha;
    to.data.resize(std::size_t(4) * to.width * to.height);
    auto* out = reinterpret_cast<std::uint8_t*>(to.data.data());
    for (int y = 0; y < from.height; ++y) {
        const std::byte* p = from.row(y);
        for (int x = 0; x < from.width; ++x, p += from.pixelBytes(), out += 4) convertPixel(from, p, out);
    }
    return to;
}

}  // namespace

std::shared_ptr<const Image> screenPicture(const std::shared_ptr<const Image>& picture) {
    const bool colour = picture->channels == (picture->alpha ? 4 : 3);
    if (picture->type == PixelType::UInt8 && colour) return picture;
    return std::make_shared<const Image>(converted(*picture));
}

QImage toQImage(const Image& warped) {
    const auto* data = reinterpret_cast<const uchar*>(warped.data.data());
    const auto format = warped.unassociated ? QImage::Format_RGBA8888 : QImage::Format_RGBA8888_Premultiplied;
    const QImage borrowed(data, warped.width, warped.height, 4 * warped.width, format);
    return borrowed.convertToFormat(QImage::Format_ARGB32_Premultiplied);
}

}  // namespace wend
