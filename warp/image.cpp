#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "core/mesh/error.h"
#include "core/mesh/safe_file.h"
#include "warp/image.h"
#include "warp/webp.h"

namespace wend {

struct Image::Metadata {
    OIIO::ImageSpec spec;
};

namespace {

std::string extensionOf(const std::string& path) {
    std::string extension = std::filesystem::path(path).extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return std::tolower(c); });
    return extension;
}

OIIO::TypeDesc typeOf(PixelType type) {
    switch (type) {
        case PixelType::UInt8:
            return OIIO::TypeDesc::UINT8;
        case PixelType::UInt16:
            return OIIO::TypeDesc::UINT16;
        case PixelType::Half:
            return OIIO::TypeDesc::HALF;
        case PixelType::Float:
            return OIIO::TypeDesc::FLOAT;
    }
    return OIIO::TypeDesc::UNKNOWN;
}

PixelType pixelTypeOf(const OIIO::TypeDesc& type) {
    switch (type.basetype) {
        case OIIO::TypeDesc::UINT8:
        case OIIO::TypeDesc::INT8:
            return PixelType::UInt8;
        case OIIO::TypeDesc::UINT16:
        case OIIO::TypeDesc::INT16:
            return PixelType::UInt16;
        case OIIO::TypeDesc::HALF:
            return PixelType::Half;
        default:
            return PixelType::Float;
    }
}

/// "why" of a library message that may run over several lines.
std::string firstLine(const std::string& text, const std::string& otherwise) {
    const std::string line = text.substr(0, text.find('\n'));
    return line.empty() ? otherwise : line;
}

void requireFile(const std::string& path) {
    std::error_code error;
    if (!std::filesystem::exists(path, error)) throw InputError(path, "does not exist");
    if (std::filesystem::is_directory(path, error)) throw InputError(path, "is a folder");
    if (std::filesystem::file_size(path, error) == 0) throw InputError(path, "is empty");
}

/// JPEG decoders fill what is missing with grey and say nothing: a whole file ends with the marker FF D9.
void requireWholeJpeg(const std::string& path) {
    std::ifstream file(path, std::ios::binary | std::ios::ate);
    const std::streamoff size = file.tellg();
    const std::streamoff tail = std::min<std::streamoff>(size, 65536);
    std::string bytes(static_cast<std::size_t>(tail), '\0');
    file.seekg(size - tail);
    file.read(bytes.data(), tail);
    if (bytes.find("\xFF\xD9") == std::string::npos)
        throw InputError(path, "is cut short: the picture's end is missing");
}

std::unique_ptr<OIIO::ImageInput> openFile(const std::string& path) {
    requireFile(path);
    OIIO::ImageSpec config;
    config["oiio:UnassociatedAlpha"] = 1;  // otherwise colours are multiplied and rounded
    auto input = OIIO::ImageInput::open(path, &config);
    if (!input)
        throw InputError(
            path, "is not a picture that can be read: " + firstLine(OIIO::geterror(), "unknown format"));
    return input;
}

Image describe(const OIIO::ImageSpec& spec) {
    Image image;
    image.width = spec.width;
    image.height = spec.height;
    image.channels = std::min(spec.nchannels, 4);
    image.type = pixelTypeOf(spec.format);
    image.alpha = spec.alpha_channel == image.channels - 1 && spec.alpha_channel > 0;
    image.unassociated = image.alpha && spec.get_int_attribute("oiio:UnassociatedAlpha") != 0;
    return image;
}

bool isWebp(const OIIO::ImageInput& input) {
    return std::string(input.format_name()) == "webp";
}

void requireSense(const std::string& path, const OIIO::ImageSpec& spec, double maxMegapixels) {
    if (spec.width <= 0 || spec.height <= 0 || spec.nchannels <= 0) throw InputError(path, "has no pixels");
    const double megapixels = static_cast<double>(spec.width) * spec.height / 1e6;
    if (megapixels > maxMegapixels)
        throw InputError(path, "has " + std::to_string(std::lround(megapixels)) +
                                   " megapixels, more than the " +
                                   std::to_string(std::lround(maxMegapixels)) + " that are allowed");
    if (spec.depth > 1) throw InputError(path, "is a volume of voxels, not a picture");
}

/// Turns the picture as its EXIF orientation (1 … 8) asks for.
Image oriented(const Image& image, int orientation) {
    if (orientation <= 1 || orientation > 8) return image;
    const bool swaps = orientation >= 5;
    Image turned = image;
    if (swaps) std::swap(turned.width, turned.height);
    const std::size_t bytes = image.pixelBytes();
    for (int y = 0; y < turned.height; ++y) {
        for (int x = 0; x < turned.width; ++x) {
            int sx = swaps ? y : x, sy = swaps ? x : y;
            if (orientation == 2 || orientation == 3 || orientation == 7 || orientation == 8)
                sx = image.width - 1 - sx;
            if (orientation == 3 || orientation == 4 || orientation == 6 || orientation == 7)
                sy = image.height - 1 - sy;
            std::memcpy(turned.row(y) + x * bytes, image.row(sy) + sx * bytes, bytes);
        }
    }
    return turned;
}

/// What a format can hold of a picture.
struct FormatLimits {
    bool alpha = true;
    std::array<bool, 4> types = {true, false, false, false};  // by PixelType
};

FormatLimits limitsOf(const std::string& extension) {
    if (extension == ".jpg" || extension == ".jpeg") return {false, {true, false, false, false}};
    if (extension == ".png") return {true, {true, true, false, false}};
    if (extension == ".tif" || extension == ".tiff") return {true, {true, true, false, true}};
    if (extension == ".exr") return {true, {false, false, true, true}};
    if (extension == ".hdr") return {false, {false, false, false, true}};
    if (extension == ".bmp" || extension == ".ppm") return {false, {true, false, false, false}};
    return {};
}

PixelType nearestType(PixelType wanted, const FormatLimits& limits) {
    const int at = static_cast<int>(wanted);
    for (int k = at; k < 4; ++k)
        if (limits.types[k]) return static_cast<PixelType>(k);
    for (int k = at; k >= 0; --k)
        if (limits.types[k]) return static_cast<PixelType>(k);
    return PixelType::UInt8;
}

/// Without an alpha channel, laid over white.
Image overWhite(const Image& image) {
    std::vector<float> values(static_cast<std::size_t>(image.width) * image.height * image.channels);
    OIIO::convert_pixel_values(typeOf(image.type), image.data.data(), OIIO::TypeDesc::FLOAT, values.data(),
                               static_cast<int>(values.size()));
    const int colours = image.channels - 1;
    std::vector<float> flat;
    flat.reserve(values.size() / image.channels * colours);
    for (std::size_t p = 0; p < values.size(); p += image.channels) {
        const float alpha = values[p + colours];
        for (int c = 0; c < colours; ++c)
            flat.push_back((image.unassociated ? values[p + c] * alpha : values[p + c]) + (1 - alpha));
    }
    Image result = image;
    result.channels = colours;
    result.alpha = result.unassociated = false;
    result.data.resize(static_cast<std::size_t>(image.width) * image.height * result.pixelBytes());
    OIIO::convert_pixel_values(OIIO::TypeDesc::FLOAT, flat.data(), typeOf(image.type), result.data.data(),
                               static_cast<int>(flat.size()));
    return result;
}

Image converted(const Image& image, PixelType type) {
    Image result = image;
    result.type = type;
    if (type == image.type) return result;
    result.data.resize(static_cast<std::size_t>(image.width) * image.height * result.pixelBytes());
    OIIO::convert_pixel_values(typeOf(image.type), image.data.data(), typeOf(type), result.data.data(),
                               image.width * image.height * image.channels);
    return result;
}

OIIO::ImageSpec specFor(const Image& image, const std::string& extension, PixelType type) {
    OIIO::ImageSpec spec(image.width, image.height, image.channels, typeOf(type));
    if (image.metadata) {
        const OIIO::ImageSpec& read = image.metadata->spec;
        spec.extra_attribs = read.extra_attribs;
        for (const char* name :
             {"oiio:BitsPerSample", "Orientation", "oiio:UnassociatedAlpha", "compression", "tiff:*"})
            spec.erase_attribute(name);
    }
    spec.default_channel_names();
    spec.alpha_channel = image.alpha ? image.channels - 1 : -1;
    if (image.unassociated) spec["oiio:UnassociatedAlpha"] = 1;
    if (extension == ".jpg" || extension == ".jpeg") spec["Compression"] = "jpeg:95";
    return spec;
}

bool tryWrite(const std::string& path, const OIIO::ImageSpec& spec, const Image& image, std::string& why) {
    auto output = OIIO::ImageOutput::create(path);
    if (!output) {
        why = "pictures cannot be written in this format";
        OIIO::geterror();
        return false;
    }
    const bool good = output->open(path, spec) &&
                      output->write_image(typeOf(image.type), image.data.data()) && output->close();
    if (!good) why = firstLine(output->geterror(), "the disk may be full");
    return good;
}

}  // namespace

std::size_t Image::pixelBytes() const {
    static constexpr std::array<std::size_t, 4> kBytes = {1, 2, 2, 4};
    return kBytes[static_cast<int>(type)] * static_cast<std::size_t>(channels);
}
const std::byte* Image::row(int y) const {
    return data.data() + static_cast<std::size_t>(y) * width * pixelBytes();
}
std::byte* Image::row(int y) {
    return data.data() + static_cast<std::size_t>(y) * width * pixelBytes();
}

Image readImageHeader(const std::string& path) {
    return describe(openFile(path)->spec());
}

Image readImage(const std::string& path, double maxMegapixels) {
    const auto input = openFile(path);
    const OIIO::ImageSpec spec = input->spec();
    requireSense(path, spec, maxMegapixels);
    if (std::string(input->format_name()) == "jpeg") requireWholeJpeg(path);
    Image image = describe(spec);
    image.data.resize(static_cast<std::size_t>(image.width) * image.height * image.pixelBytes());
    if (isWebp(*input) && image.channels >= 3 && readWebp(path, image)) {
        image.unassociated = image.alpha;
        return image;
    }
    const bool good = input->read_image(0, 0, 0, image.channels, typeOf(image.type), image.data.data());
    const std::string complaint = input->geterror();
    if (!good || !complaint.empty())
        throw InputError(path, "is damaged: " + firstLine(complaint, "pixels are missing"));
    auto metadata = std::make_shared<Image::Metadata>();
    metadata->spec = spec;
    image.metadata = metadata;
    return oriented(image, spec.get_int_attribute("Orientation", 1));
}

void writeImage(const std::string& path, const Image& image) {
    const std::string extension = extensionOf(path);
    const FormatLimits limits = limitsOf(extension);
    if (image.alpha && !limits.alpha) return writeImage(path, overWhite(image));
    const PixelType type = nearestType(image.type, limits);
    if (extension == ".webp")
        return writeWhole(path, [&](const std::string& temporary) {
            std::string why;
            if (!writeWebp(temporary, converted(image, type), why))
                throw InputError(path, "cannot be written: " + why);
        });
    writeWhole(path, [&](const std::string& temporary) {
        OIIO::ImageSpec spec = specFor(image, extension, type);
        std::string why;
        if (tryWrite(temporary, spec, image, why)) return;
        spec.erase_attribute(
            "ICCProfile");  // one that the format's library refuses must not cost the picture
        if (!tryWrite(temporary, spec, image, why)) throw InputError(path, "cannot be written: " + why);
    });
}

}  // namespace wend
