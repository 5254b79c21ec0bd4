#include "app/bench/test_picture.h"

namespace wend {

Image testPicture(int width, int height) {
    Image image;
    image.width = width;
    image.height = height;
    image.channels = 4;
    image.alpha = true;
    image.type = PixelType::UInt8;
    image.data.resize(static_cast<std::size_t>(width) * height * 4);
    auto* out = reinterpret_cast<unsigned char*>(image.data.data());
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            *out++ = static_cast<unsigned char>((x * x / 700 + y * y / 900) >> 3);
            *out++ = static_cast<unsigned char>(x >> 4);
            *out++ = static_cast<unsigned char>(y >> 4);
            *out++ = 255;
        }
    return image;
}

}  // namespace wend
