#include <cmath>
#include <cstddef>

#include "core/mesh/error.h"
#include "core/mesh/input_file.h"
#include "warp/image.h"
#include "warp/orientation.h"
#include "warp/picture_process.h"
#include "warp/pixels.h"

namespace wend {
namespace {

/// Says how many pixels have numbers that are not finite, and where the first one is; empty without any.
std::string oddPixels(const Image& image) {
    if (image.type != PixelType::Half && image.type != PixelType::Float) return {};
    return withPixelType(image.type, [&](auto t) {
        using T = decltype(t);
        std::size_t count = 0, first = 0;
        const auto pixels = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
        const T* at = reinterpret_cast<const T*>(image.data.data());
        for (std::size_t p = 0; p < pixels; ++p, at += image.channels) {
            float sum = 0;  // 0 times a number that is not finite is not a number
            for (int c = 0; c < image.channels; ++c) sum += 0 * static_cast<float>(at[c]);
            if (std::isnan(sum) && count++ == 0) first = p;
        }
        if (count == 0) return std::string();
        const auto width = static_cast<std::size_t>(image.width);
        const std::string x = std::to_string(first % width), y = std::to_string(first / width);
        return count == 1
                   ? "1 pixel is not a finite number (NaN or infinity), at x " + x + ", y " + y
                   : std::to_string(count) +
                         " pixels are not finite numbers (NaN or infinity), the first at x " + x + ", y " + y;
    });
}

Image readUpright(const std::string& path, const std::string& layer, double maxMegapixels,
                  std::vector<std::string>* notices) try {
    StoredPicture stored = readPicture(path, {.megapixels = maxMegapixels}, layer);
    Image image = upright(std::move(stored.image), stored.orientation);
    if (!notices) return image;
    if (std::string odd = oddPixels(image); !odd.empty()) stored.notices.push_back(std::move(odd));
    for (const std::string& notice : stored.notices) notices->push_back(InputError(path, notice).what());
    return image;
} catch (const OutOfMemory&) {
    throw;
} catch (const std::bad_alloc&) {
    throw OutOfMemory(path);
}

}  // namespace

Image readImageHeader(const std::string& path) {
    auto [image, orientation, ignored] = readPictureHeader(path);
    if (orientation >= 5) std::swap(image.width, image.height);
    return std::move(image);
}

Image readImage(const std::string& path, double maxMegapixels, std::vector<std::string>* notices) {
    return readUpright(path, {}, maxMegapixels, notices);
}

Image readLayer(const std::string& path, const std::string& layer, std::vector<std::string>* notices) {
    return readUpright(path, layer, kMaxMegapixels, notices);
}

}  // namespace wend
