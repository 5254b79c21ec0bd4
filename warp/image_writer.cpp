#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <string_view>

#include <OpenImageIO/filesystem.h>

#include "core/mesh/error.h"
#include "core/mesh/file_name.h"
#include "core/mesh/safe_file.h"
#include "warp/convert.h"
#include "warp/image_metadata.h"
#include "warp/webp.h"

namespace wend {
namespace {

enum class Association { Unassociated, Associated, Either };

/// What a format can hold.
struct Format {
    std::array<std::string_view, 3> extensions;
    std::array<bool, 4> types;  // UInt8, UInt16, Half, Float
    bool gray, alpha, grayAlpha;
    Association association;
    std::string_view compression;
};

constexpr std::array formats{
    Format{{".png"}, {true, true, false, false}, true, true, true, Association::Unassociated, ""},
    Format{{".tif", ".tiff"}, {true, true, true, true}, true, true, true, Association::Either, "zip"},
    Format{{".exr"}, {false, false, true, true}, true, true, true, Association::Associated, "zip"},
    Format{{".jpg", ".jpeg", ".jpe"},
           {true, false, false, false},
           true,
           false,
           false,
           Association::Either,
           "jpeg:95"},
    Format{{".webp"}, {true, false, false, false}, false, true, false, Association::Unassociated, ""},
    Format{{".bmp"}, {true, false, false, false}, true, true, false, Association::Unassociated, ""},
    Format{{".tga"}, {true, false, false, false}, true, true, false, Association::Unassociated, "rle"},
    Format{{".jp2"}, {true, true, false, false}, true, false, false, Association::Either, ""},
    Format{{".ppm", ".pnm"}, {true, false, false, false}, true, false, false, Association::Either, ""},
    Format{{".hdr"}, {false, false, false, true}, false, false, false, Association::Either, ""},
};

const Format* findFormat(const std::string& extension) {
    const auto matches = [&](const Format& format) {
        const auto& names = format.extensions;
        return !extension.empty() && std::find(names.begin(), names.end(), extension) != names.end();
    };
    const auto found = std::find_if(formats.begin(), formats.end(), matches);
    return found == formats.end() ? nullptr : &*found;
}

const Format& formatOf(const std::string& path) {
    const std::string extension = lowerExtension(path);
    if (const Format* format = findFormat(extension)) return *format;
    std::string known;
    for (const Format& format : formats)
        known += (known.empty() ? "" : ", ") + std::string(format.extensions[0].substr(1));
    throw InputError(path, (extension.empty() ? "has no extension that says the picture format"
                                              : "pictures cannot be written as " + extension) +
                               " (known: " + known + ")");
}

/// The nearest type that loses nothing, or else the format's widest: 16-bit integers need a float, a half
/// does not hold them.
PixelType nearestType(const Format& format, PixelType type) {
    const auto holds = [&](PixelType t) { return format.types[static_cast<std::size_t>(t)]; };
    if (holds(type)) return type;
    if (type == PixelType::UInt8 && holds(PixelType::Half)) return PixelType::Half;
    for (PixelType t : {PixelType::Float, PixelType::Half, PixelType::UInt16})
        if (holds(t)) return t;
    return PixelType::UInt8;
}

bool storedUnassociated(const Format& format, const Image& image) {
    if (format.association == Association::Either) return image.unassociated;
    return format.association == Association::Unassociated;
}

PixelLayout fileLayout(const Format& format, const Image& image) {
    PixelLayout layout;
    layout.type = nearestType(format, image.type);
    const bool gray = image.colours() < 3;
    layout.alpha = image.alpha && format.alpha;
    const bool widen = gray && (!format.gray || (layout.alpha && !format.grayAlpha));
    layout.channels = (gray && !widen ? 1 : 3) + (layout.alpha ? 1 : 0);
    layout.unassociated = layout.alpha && storedUnassociated(format, image);
    return layout;
}

/// Attributes that describe how the source's pixels were stored, which is not how these are.
bool describesStorage(std::string_view name) {
    for (std::string_view prefix :
         {"tiff:", "png:", "jpeg:", "gif:", "webp:", "openexr:", "thumbnail_", "heif:", "raw:"})
        if (name.starts_with(prefix)) return true;
    for (std::string_view word :
         {"compression", "planarconfig", "oiio:BitsPerSample", "oiio:UnassociatedAlpha", "oiio:subimages",
          "oiio:subimagename", "oiio:Movie", "FramesPerSecond", "textureformat", "wrapmodes", "fovcot",
          "tiled"})
        if (name == word) return true;
    return false;
}

OIIO::TypeDesc fileType(PixelType type) {
    constexpr std::array types{OIIO::TypeDesc::UINT8, OIIO::TypeDesc::UINT16, OIIO::TypeDesc::HALF,
                               OIIO::TypeDesc::FLOAT};
    return types[static_cast<std::size_t>(type)];
}

/// A crop window that a file of the same size carried stays.
void copyWindow(const OIIO::ImageSpec& from, OIIO::ImageSpec& to) {
    if (from.width != to.width || from.height != to.height) return;
    to.x = from.x, to.y = from.y;
    to.full_x = from.full_x, to.full_y = from.full_y;
    to.full_width = from.full_width, to.full_height = from.full_height;
}

OIIO::ImageSpec fileSpec(const Format& format, const Image& image) {
    OIIO::ImageSpec spec(image.width, image.height, image.channels, fileType(image.type));
    if (image.colours() == 1) spec.channelnames[0] = "Y";
    if (image.alpha) spec.channelnames.back() = "A";
    spec.alpha_channel = image.alpha ? image.channels - 1 : -1;
    if (image.metadata) {
        for (const OIIO::ParamValue& value : image.metadata->spec.extra_attribs)
            if (!describesStorage(value.name().string())) spec.extra_attribs.add_or_replace(value);
        copyWindow(image.metadata->spec, spec);
    }
    if (image.alpha && image.unassociated) spec.attribute("oiio:UnassociatedAlpha", 1);
    if (!format.compression.empty()) spec.attribute("compression", std::string(format.compression));
    if (format.compression.starts_with("jpeg")) spec.attribute("jpeg:subsampling", "4:4:4");
    return spec;
}

/// The reason of a failure, empty on success.
std::string tryWriteTo(OIIO::ImageOutput& output, const std::string& path, const Image& image,
                       const OIIO::ImageSpec& spec) {
    if (!output.open(path, spec)) return "cannot be opened for writing: " + output.geterror();
    const bool written = output.write_image(spec.format, image.data.data());
    const std::string error = output.geterror();
    const bool closed = output.close();
    if (written && closed) return {};
    return error.empty() ? "the disk may be full" : error;
}

/// Whether the format's library tells of a full disk. Those of PNG, BMP and Targa do not, and that of JPEG
/// ends the process.
bool tellsOfFullDisk(const OIIO::ImageOutput& output) {
    const std::string format = output.format_name();
    return format != "png" && format != "jpeg" && format != "bmp" && format != "targa";
}

std::string putBytes(const std::string& path, const std::vector<unsigned char>& bytes) {
    std::ofstream file(path, std::ios::binary);
    file.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    file.close();
    return file ? "" : "the disk may be full";
}

std::string tryWrite(const std::string& path, const Image& image, OIIO::ImageSpec spec) {
    const auto output = OIIO::ImageOutput::create(path);
    if (!output) return OIIO::geterror();
    if (tellsOfFullDisk(*output) || !output->supports("ioproxy"))
        return tryWriteTo(*output, path, image, spec);
    std::vector<unsigned char> bytes;
    OIIO::Filesystem::IOVecOutput memory(bytes);
    OIIO::Filesystem::IOProxy* proxy = &memory;
    spec.attribute("oiio:ioproxy", OIIO::TypeDesc::PTR, &proxy);
    const std::string error = tryWriteTo(*output, path, image, spec);
    return error.empty() ? putBytes(path, bytes) : error;
}

/// `text` with the temporary file called by its proper name.
std::string properlyNamed(std::string text, const std::string& temporary, const std::string& path) {
    const auto at = text.find(temporary);
    return at == std::string::npos ? text : text.replace(at, temporary.size(), path);
}

/// A colour profile that the format's library refuses fails the whole file: better the picture without it.
void writePicture(const std::string& path, const std::string& temporary, const Image& image,
                  OIIO::ImageSpec spec) {
    std::string error = tryWrite(temporary, image, spec);
    if (!error.empty() && spec.find_attribute("ICCProfile")) {
        spec.erase_attribute("ICCProfile");
        error = tryWrite(temporary, image, spec);
    }
    if (!error.empty()) {
        error = properlyNamed(error, temporary, path);
        throw InputError(path, "cannot be written: " + error.substr(0, error.find('\n')));
    }
}

/// OpenImageIO's own WebP rounds the colours of transparent pixels and drops the profile.
void writePixels(const Format& format, const std::string& path, const std::string& temporary,
                 const Image& image) {
    const OIIO::ImageSpec spec = fileSpec(format, image);
    if (format.extensions[0] != ".webp") return writePicture(path, temporary, image, spec);
    const std::string error = writeWebp(temporary, image, spec);
    if (!error.empty()) throw InputError(path, "cannot be written: " + error);
}

}  // namespace

bool canWriteImage(const std::string& path) {
    return findFormat(lowerExtension(path)) != nullptr;
}

void writeImage(const std::string& path, const Image& image) {
    const Format& format = formatOf(path);
    if (image.width < 1 || image.height < 1) throw InputError(path, "there are no pixels to write");
    const PixelLayout layout = fileLayout(format, image);
    const Image stored = layout == layoutOf(image) ? Image() : converted(image, layout);
    const Image& pixels = stored.data.empty() ? image : stored;
    writeWhole(path, [&](const std::string& temporary) { writePixels(format, path, temporary, pixels); });
}

}  // namespace wend
