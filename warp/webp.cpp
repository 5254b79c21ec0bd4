#include "warp/webp.h"

#include <webp/decode.h>
#include <webp/encode.h>

#include <fstream>
#include <iterator>
#include <memory>

namespace wend {
namespace {

/// RGB or RGBA bytes, colours not multiplied with alpha, as WebP wants them.
std::vector<std::uint8_t> toRgba(const Image& image) {
    const int colours = image.channels - (image.alpha ? 1 : 0);
    std::vector<std::uint8_t> bytes;
    bytes.reserve(static_cast<std::size_t>(image.width) * image.height * (image.alpha ? 4 : 3));
    const auto* p = reinterpret_cast<const std::uint8_t*>(image.data.data());
    for (std::size_t k = 0; k < static_cast<std::size_t>(image.width) * image.height;
         ++k, p += image.channels) {
        const unsigned alpha = image.alpha ? p[colours] : 255;
        for (int c = 0; c < 3; ++c) {
            const unsigned value = p[colours >= 3 ? c : 0];
            const bool divide = image.alpha && !image.unassociated && alpha > 0;
            bytes.push_back(static_cast<std::uint8_t>(
                divide ? std::min(255U, (value * 255 + alpha / 2) / alpha) : value));
        }
        if (image.alpha) bytes.push_back(static_cast<std::uint8_t>(alpha));
    }
    return bytes;
}

using Picture = std::unique_ptr<WebPPicture, void (*)(WebPPicture*)>;
using Writer = std::unique_ptr<WebPMemoryWriter, void (*)(WebPMemoryWriter*)>;

}  // namespace

bool writeWebp(const std::string& path, const Image& image, std::string& why) {
    if (image.width > WEBP_MAX_DIMENSION || image.height > WEBP_MAX_DIMENSION) {
        why = "WebP holds at most " + std::to_string(WEBP_MAX_DIMENSION) + " pixels a side";
        return false;
    }
    WebPConfig config;
    WebPPicture picture;
    WebPMemoryWriter writer;
    if (WebPConfigInit(&config) == 0 || WebPConfigLosslessPreset(&config, 3) == 0 ||
        WebPPictureInit(&picture) == 0)
        return false;
    config.exact = 1;  // colours under transparent pixels stay too
    WebPMemoryWriterInit(&writer);
    const Picture pictureGuard(&picture, WebPPictureFree);
    const Writer writerGuard(&writer, WebPMemoryWriterClear);
    picture.use_argb = 1;
    picture.width = image.width;
    picture.height = image.height;
    picture.writer = WebPMemoryWrite;
    picture.custom_ptr = &writer;
    const std::vector<std::uint8_t> bytes = toRgba(image);
    const int good = image.alpha ? WebPPictureImportRGBA(&picture, bytes.data(), 4 * image.width)
                                 : WebPPictureImportRGB(&picture, bytes.data(), 3 * image.width);
    if (good == 0 || WebPEncode(&config, &picture) == 0) {
        why = "the WebP encoder failed (" + std::to_string(picture.error_code) + ")";
        return false;
    }
    std::ofstream file(path, std::ios::binary);
    file.write(reinterpret_cast<const char*>(writer.mem), static_cast<std::streamsize>(writer.size));
    file.close();
    if (!file) why = "the disk may be full";
    return static_cast<bool>(file);
}

bool readWebp(const std::string& path, Image& image) {
    std::ifstream file(path, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(file), {}};
    const auto* data = reinterpret_cast<const std::uint8_t*>(bytes.data());
    auto* target = reinterpret_cast<std::uint8_t*>(image.data.data());
    const int stride = image.width * image.channels;
    if (image.channels == 4)
        return WebPDecodeRGBAInto(data, bytes.size(), target, image.data.size(), stride) != nullptr;
    return WebPDecodeRGBInto(data, bytes.size(), target, image.data.size(), stride) != nullptr;
}

}  // namespace wend
