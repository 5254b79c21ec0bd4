#include "core/mesh/error.h"
#include "warp/bmp_check.h"
#include "warp/image.h"
#include "warp/metadata_check.h"
#include "warp/orientation.h"
#include "warp/picture_format.h"
#include "warp/picture_library.h"
#include "warp/png_check.h"
#include "warp/tga_check.h"

namespace wend {
namespace {

/// What the format's library would not bear; empty if nothing is known.
std::string problemOf(const InputFile& file, PictureFormat format) {
    switch (format) {
        case PictureFormat::Png:
            return pngProblem(file);
        case PictureFormat::Bmp:
            return bmpProblem(file);
        case PictureFormat::Tga:
            return tgaProblem(file);
        default:
            return {};
    }
}

/// What is in the file decides, not its name.
PictureSource sourceOf(const std::string& path) {
    const InputFile file(path);
    const PictureFormat format = pictureFormat(file);
    if (const std::string problem = problemOf(file, format); !problem.empty())
        throw InputError(path, problem);
    return {path, format, bytesWithSoundMetadata(file, format)};
}

}  // namespace

Image readImageHeader(const std::string& path) {
    auto [image, orientation] = pictureLibrary(path).readHeader(sourceOf(path));
    if (orientation >= 5) std::swap(image.width, image.height);
    return std::move(image);
}

Image readImage(const std::string& path, double maxMegapixels) try {
    StoredPicture stored = pictureLibrary(path).read(sourceOf(path), maxMegapixels, requireReading);
    return upright(std::move(stored.image), stored.orientation);
} catch (const OutOfMemory&) {
    throw;
} catch (const std::bad_alloc&) {
    throw OutOfMemory(path);
}

}  // namespace wend
