#include "app/view/screen_picture.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstring>

namespace wend {

namespace {

Image blank(int width, int height) {
    Image image;
    image.width = width;
    image.height = height;
    image.channels = 4;
    image.alpha = true;
    image.data.resize(std::size_t(4) * width * height);
    return image;
}

std::uint8_t* bytes(Image& image, int x, int y) {
    return reinterpret_cast<std::uint8_t*>(image.data.data()) + 4 * (std::size_t(y) * image.width + x);
}

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

void convertPixel(const Image& from, const std::byte* p, std::uint8_t* to) {
    const bool linear = from.type == PixelType::Half || from.type == PixelType::Float;
    const int colours = from.channels - (from.alpha ? 1 : 0);
    const float alpha =
        from.alpha ? std::clamp(component(p, from.type, from.channels - 1), 0.0F, 1.0F) : 1.0F;
    for (int c = 0; c < 3; ++c) {
        float value = component(p, from.type, colours >= 3 ? c : 0);
        if (linear) {
            const float own = from.unassociated || alpha <= 0 ? value : value / alpha;
            value = encoded(own) * alpha;
        } else if (from.unassociated) {
            value *= alpha;
        }
        to[c] = static_cast<std::uint8_t>(std::lround(255 * std::clamp(value, 0.0F, alpha)));
    }
    to[3] = static_cast<std::uint8_t>(std::lround(255 * alpha));
}

}  // namespace

Image toScreen(const Image& from) {
    Image to = blank(from.width, from.height);
    const bool isBytes =
        from.type == PixelType::UInt8 && from.channels == 4 && from.alpha && !from.unassociated;
    if (isBytes) {
        to.data = from.data;
        return to;
    }
    for (int y = 0; y < from.height; ++y) {
        const std::byte* p = from.row(y);
        for (int x = 0; x < from.width; ++x, p += from.pixelBytes()) convertPixel(from, p, bytes(to, x, y));
    }
    return to;
}

QImage toQImage(const Image& image) {
    const auto* data = reinterpret_cast<const uchar*>(image.data.data());
    return QImage(data, image.width, image.height, 4 * image.width, QImage::Format_RGBA8888_Premultiplied)
        .copy();
}

}  // namespace wend
