#include "bench/test_picture.h"

#include "warp/convert.h"

namespace wend {

Image testPicture(int width, int height, PixelType type) {
    Image image;
    image.width = width;
    image.height = height;
    image.channels = 4;
    image.alpha = true;
    image.type = PixelType::UInt8;
    image.makePixels();
    auto* out = reinterpret_cast<unsigned char*>(image.data.data());
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            *out++ = static_cast<unsigned char>((x * x / 700 + y * y / 900) >> 3);
            *out++ = static_cast<unsigned char>(x >> 4);
            *out++ = static_cast<unsigned char>(y >> 4);
            *out++ = 255;
        }
    return converted(image, {type, image.channels, image.alpha, image.unassociated});
}

}  // namespace wend
