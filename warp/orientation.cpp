#include "warp/orientation.h"

#include <cstring>
#include <utility>

namespace wend {

Image upright(Image image, int orientation) {
    if (orientation < 2 || orientation > 8) return image;
    const bool swapped = orientation >= 5;  // stored rows are displayed columns
    const bool flipX = orientation == 2 || orientation == 3 || orientation == 7 || orientation == 8;
    const bool flipY = orientation == 3 || orientation == 4 || orientation == 6 || orientation == 7;
    Image result = image;
    if (swapped) std::swap(result.width, result.height);
    const std::size_t bytes = image.pixelBytes();
    for (int y = 0; y < result.height; ++y) {
        std::byte* out = result.row(y);
        for (int x = 0; x < result.width; ++x, out += bytes) {
            const int column = swapped ? y : x, line = swapped ? x : y;
            const int u = flipX ? image.width - 1 - column : column;
            const int v = flipY ? image.height - 1 - line : line;
            std::memcpy(out, image.row(v) + static_cast<std::size_t>(u) * bytes, bytes);
        }
    }
    return result;
}

}  // namespace wend
