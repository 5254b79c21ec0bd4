#include <cmath>
#include <cstddef>

#include "core/mesh/error.h"
#include "warp/bmp_check.h"
#include "warp/byte_numbers.h"
#include "warp/image.h"
#include "warp/metadata_check.h"
#include "warp/orientation.h"
#include "warp/picture_format.h"
#include "warp/picture_library.h"
#include "warp/pixels.h"
#include "warp/png_check.h"
#include "warp/png_colours.h"
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

void tellOf(const PngExtras& extras, std::vector<std::string>& notices) {
    if (extras.frames > 1) notices.push_back(severalPictures(extras.frames));
    if (!extras.unknownColours.empty())
        notices.push_back("has a colour space that is not known (cICP " + extras.unknownColours +
                          "): it is not kept");
}

/// Whether the first directory of a TIFF says what the samples after the colours are (tag 338). Of a BigTIFF,
/// and of one that is cut off, nothing is known.
bool namesExtraSamples(const InputFile& file) {
    constexpr std::uint32_t kClassic = 42, kExtraSamples = 338;
    constexpr std::size_t kEntry = 12;
    const std::string head = file.bytes(0, 8);
    if (head.size() < 8) return true;
    const auto number = [&](const std::string& bytes, std::size_t at, std::size_t size) {
        return head[0] == 'I' ? littleEndian(bytes, at, size) : bigEndian(bytes, at, size);
    };
    const std::uint64_t directory = number(head, 4, 4);
    const std::string count = file.bytes(directory, 2);
    if (number(head, 2, 2) != kClassic || count.size() < 2) return true;
    const std::string entries = file.bytes(directory + 2, kEntry * number(count, 0, 2));
    for (std::size_t at = 0; at + kEntry <= entries.size(); at += kEntry)
        if (number(entries, at, 2) == kExtraSamples) return true;
    return false;
}

/// What is in the file decides, not its name.
PictureSource sourceOf(const std::string& path, std::vector<std::string>& notices) {
    const InputFile file(path);
    const PictureFormat format = pictureFormat(file);
    if (const std::string problem = problemOf(file, format); !problem.empty())
        throw InputError(path, problem);
    PictureSource source{path, format, bytesWithSoundMetadata(file, format)};
    if (format == PictureFormat::Tiff) source.namesExtraSamples = namesExtraSamples(file);
    if (format != PictureFormat::Png) return source;
    const PngExtras extras = pngExtras(file);
    source.colours = extras.colours;
    tellOf(extras, notices);
    return source;
}

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

}  // namespace

Image readImageHeader(const std::string& path) {
    std::vector<std::string> notices;
    auto [image, orientation, ignored] = pictureLibrary(path).readHeader(sourceOf(path, notices));
    if (orientation >= 5) std::swap(image.width, image.height);
    return std::move(image);
}

Image readImage(const std::string& path, double maxMegapixels, std::vector<std::string>* notices) try {
    std::vector<std::string> found;
    StoredPicture stored = pictureLibrary(path).read(sourceOf(path, found), maxMegapixels, requireReading);
    found.insert(found.end(), stored.notices.begin(), stored.notices.end());
    Image image = upright(std::move(stored.image), stored.orientation);
    if (!notices) return image;
    if (std::string odd = oddPixels(image); !odd.empty()) found.push_back(std::move(odd));
    for (const std::string& notice : found) notices->push_back(InputError(path, notice).what());
    return image;
} catch (const OutOfMemory&) {
    throw;
} catch (const std::bad_alloc&) {
    throw OutOfMemory(path);
}

}  // namespace wend
