#include <algorithm>
#include <cmath>
#include <cstddef>
#include <tuple>

#include "core/base/error.h"
#include "core/base/input_file.h"
#include "warp/atlas.h"
#include "warp/drawn_picture.h"
#include "warp/image.h"
#include "warp/orientation.h"
#include "warp/picture_metadata.h"
#include "warp/picture_process.h"
#include "warp/pixels.h"

namespace wend {
namespace {

/// Says how many pixels have numbers that are not finite, and where the first one is; empty without any.
Message oddPixels(const Image& image) {
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
        if (count == 0) return Message();
        const auto width = static_cast<std::size_t>(image.width);
        const std::size_t x = first % width, y = first / width;
        if (count == 1)
            return Message(
                sentence("Core", "1 pixel is not a finite number (NaN or infinity), at x %1, y %2"), x, y);
        return Message(
            sentence("Core", "%1 pixels are not finite numbers (NaN or infinity), the first at x %2, y %3"),
            count, x, y);
    });
}

Image readUpright(const std::string& path, const std::string& layer, const PictureLimits& limits,
                  std::vector<Message>* notices) try {
    StoredPicture stored = readPicture(path, limits, layer);
    Image image = upright(std::move(stored.image), stored.orientation);
    if (!notices) return image;
    if (Message odd = oddPixels(image); !odd.isEmpty()) stored.notices.push_back(std::move(odd));
    for (const Message& notice : stored.notices) notices->push_back(path + ": " + notice);
    return image;
} catch (const OutOfMemory&) {
    throw;
} catch (const std::bad_alloc&) {
    throw OutOfMemory(path);
}

/// Returns whether the file's layers are its pages, of which the first is what a reader finds.
bool hasPagesAsLayers(const std::string& path, const Image& image) {
    return !fileMetadata(image)->layers.empty() && pictureFormat(InputFile(path)) == PictureFormat::Tiff;
}

/// Returns the size of all pages, at their places.
std::pair<int, int> sizeOf(const std::vector<PictureLayer>& pages) {
    int width = 1, height = 1;
    for (const PictureLayer& page : pages) {
        width = std::max(width, page.x + page.width);
        height = std::max(height, page.y + page.height);
    }
    return {width, height};
}

/// Returns the pages over one another, the first one below.
Image flattenedPages(const std::string& path, const Image& first, double maxMegapixels) {
    const std::vector<PictureLayer>& pages = fileMetadata(first)->layers;
    const auto [width, height] = sizeOf(pages);
    if (width * 1e-6 * height > maxMegapixels) throw InputError(path, "has pages that are too far apart");
    std::vector<Sheet> sheets;
    for (const PictureLayer& page : pages) {
        const auto picture = std::make_shared<const Image>(readLayer(path, page.name));
        sheets.insert(sheets.begin(), {picture, Vec2(page.x, page.y)});
    }
    Image image = flattened(sheets, width, height);
    image.metadata = first.metadata;
    return image;
}

}  // namespace

Image readImageHeader(const std::string& path) {
    return readImageHeader(path, {});
}

Image readImageHeader(const std::string& path, const DrawnSize& drawn) {
    auto [image, orientation, ignored] = readPictureHeader(path, drawn);
    if (orientation >= 5) std::swap(image.width, image.height);
    if (hasPagesAsLayers(path, image))
        std::tie(image.width, image.height) = sizeOf(fileMetadata(image)->layers);
    return std::move(image);
}

Image readImage(const std::string& path, double maxMegapixels, std::vector<Message>* notices) {
    Image image = readUpright(path, {}, {.megapixels = maxMegapixels}, notices);
    return hasPagesAsLayers(path, image) ? flattenedPages(path, image, maxMegapixels) : image;
}

Image readImage(const std::string& path, const DrawnSize& drawn, std::vector<Message>* notices) {
    if (drawn[0] > 0 && isDrawing(path)) return readUpright(path, {}, {.drawn = drawn}, notices);
    return readImage(path, kMaxMegapixels, notices);
}

Image readLayer(const std::string& path, const std::string& layer, std::vector<Message>* notices) {
    return readLayer(path, layer, DrawnSize{}, notices);
}

Image readLayer(const std::string& path, const std::string& layer, const DrawnSize& drawn,
                std::vector<Message>* notices) {
    return readUpright(path, layer, {.drawn = drawn}, notices);
}

bool isDrawing(const std::string& path) try {
    return pictureFormat(InputFile(path)) == PictureFormat::Svg;
} catch (const InputError&) {
    return false;
}

}  // namespace wend
