#include "app/engine/shape/picture_file.h"

#include "core/base/error.h"
#include "warp/convert.h"
#include "warp/image.h"

namespace wend {

QImage pictureOfFile(const std::string& path) try {
    const Image image = converted(readImage(path), {PixelType::UInt8, 4, true, true});
    const auto* data = reinterpret_cast<const uchar*>(image.data.data());
    return QImage(data, image.width, image.height, 4 * image.width, QImage::Format_RGBA8888).copy();
} catch (const std::exception&) {
    return {};
}

}  // namespace wend
