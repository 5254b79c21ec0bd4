#include "warp/openimageio/writer.h"

#include <algorithm>
#include <array>
#include <functional>
#include <memory>
#include <string_view>

#include "core/base/error.h"
#include "warp/openimageio/checked_proxy.h"
#include "warp/openimageio/icc_profile.h"
#include "warp/openimageio/image_metadata.h"
#include "warp/openimageio/picture_codecs.h"
#include "warp/openimageio/png_text.h"
#include "warp/openimageio/webp.h"
#include "warp/picture_metadata.h"

namespace wend {
namespace {

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

/// The default compression takes five times as long for large pictures, and saves 6 %.
constexpr const char* kQuickZip = "zip:4";
constexpr int kQuickPng = 4;

bool isLarge(const Image& image) {
    return image.width * 1e-6 * image.height > 16;
}

/// Sets the place of the picture in its frame, in the coordinates of its source's file (`source` describes
/// it): EXR has a display window for the frame, PNG and TIFF have an offset (TIFF none to the left or above).
void setPlace(PictureFormat format, const Image& image, const OIIO::ImageSpec& source,
              OIIO::ImageSpec& spec) {
    const CanvasPlace& place = image.place;
    const int frameWidth = place.isOwn() ? image.width : place.frameWidth,
              frameHeight = place.isOwn() ? image.height : place.frameHeight;
    const bool hasWindow = image.metadata && image.metadata->stored.width > 0;
    int left = 0, top = 0;
    if ((hasWindow ? source.full_width : source.width) == frameWidth &&
        (hasWindow ? source.full_height : source.height) == frameHeight) {
        left = hasWindow ? source.full_x : source.x;
        top = hasWindow ? source.full_y : source.y;
    }
    spec.x = left + place.x, spec.y = top + place.y;
    if (format == PictureFormat::Exr) {
        spec.full_x = left, spec.full_y = top;
        spec.full_width = frameWidth, spec.full_height = frameHeight;
    } else if (format == PictureFormat::Tiff && (spec.x < 0 || spec.y < 0)) {
        spec.x = spec.y = 0;
    }
}

/// Drops profiles that the format does not support or its library rejects.
void dropOddProfile(PictureFormat format, OIIO::ImageSpec& spec) {
    const OIIO::ParamValue* profile = spec.find_attribute("ICCProfile");
    if (!profile) return;
    if (format == PictureFormat::Exr || (format == PictureFormat::Png && !profileIsStrict(*profile)))
        spec.erase_attribute("ICCProfile");
}

/// The result of an attempt to write: the error, empty on success, and whether the disk is the cause.
struct Attempt {
    Message problem;
    bool disk = false;
};

using Bytes = std::string_view;

std::size_t mixed(std::size_t sum, Bytes bytes) {
    return sum * 31 + std::hash<Bytes>()(bytes);
}

/// Writes all rows; `failed` reports errors that the format's library misses. `sum` receives the checksum of
/// the rows.
template <typename Failed>
Message tryWriteTo(OIIO::ImageOutput& output, const Failed& failed, const PictureToWrite& writing,
                   const OIIO::ImageSpec& spec, std::size_t& sum) {
    if (!output.open(writing.temporary, spec)) return "cannot be opened for writing: " + output.geterror();
    const bool written = writing.strips([&](int top, const Image& strip) {
        const auto* bytes = reinterpret_cast<const char*>(strip.data.data());
        for (int y = 0; y < strip.height; ++y)
            sum = mixed(sum, {bytes + y * strip.rowBytes(), strip.rowBytes()});
        return output.write_scanlines(spec.y + top, spec.y + top + strip.height, spec.z, spec.format,
                                      strip.data.data()) &&
               !failed();
    });
    const std::string error = output.geterror();
    const bool closed = output.close();
    if (written && closed) return {};
    if (error.empty()) return sentence("Core", "the disk may be full");
    return error;
}

/// Reopens a finished file with the reader of its own format, and reads its rows from `first` on. Returns the
/// error, or an empty string. `sum` receives the checksum of the rows.
Message tryToReadBack(const PictureToWrite& writing, const OIIO::ImageSpec& spec, int first,
                      std::size_t& sum) {
    const std::unique_ptr<OIIO::ImageInput> input(codecOf(writing.format).reader());
    OIIO::ImageSpec found, config;
    config.attribute("oiio:UnassociatedAlpha", writing.picture.unassociated ? 1 : 0);
    if (!input->open(writing.temporary, found, config)) return "cannot be read again: " + input->geterror();
    if (found.width != spec.width || found.height != spec.height || found.nchannels != spec.nchannels)
        return "has another size when it is read again";
    std::string row(spec.scanline_bytes(),
                    '\0');  // in the type that was handed over: a TIFF keeps halves as floats
    for (int y = found.y + first; y < found.y + found.height; ++y) {
        const bool read =
            input->read_scanlines(0, 0, y, y + 1, found.z, 0, found.nchannels, spec.format, row.data()) &&
            !input->has_error();
        if (!read) return "cannot be read again to its end";
        sum = mixed(sum, row);
    }
    return {};
}

/// libtiff reports most errors, but not all when it closes; and its output cannot go through our own file
/// object, because OpenImageIO then cannot read back what it has written. So all pixels are compared.
Attempt tryWriteTiff(OIIO::ImageOutput& output, const PictureToWrite& writing, const OIIO::ImageSpec& spec) {
    std::size_t written = 0, read = 0;
    Message problem = tryWriteTo(
        output, [] { return false; }, writing, spec, written);
    if (problem.isEmpty()) problem = tryToReadBack(writing, spec, 0, read);
    if (problem.isEmpty() && written != read) problem = "is another picture when it is read again";
    return {problem};
}

/// Writes black rows until some pixels are in the file: libpng prints a line of its own when a file without
/// any is closed.
void avoidEmptyPng(OIIO::ImageOutput& output, const PngTextProxy& proxy, const OIIO::ImageSpec& spec) {
    const std::string row(spec.scanline_bytes(), '\0');
    for (int y = spec.y; y < spec.y + spec.height && !proxy.hasPixels(); ++y)
        if (!output.write_scanline(y, spec.z, spec.format, row.data())) break;
    output.geterror();  // which is of no interest
}

/// Writes through a file object that checks, because no format library reports a full disk in every case, and
/// that of JPEG ends the process.
Attempt tryWrite(const PictureToWrite& writing, OIIO::ImageSpec spec) {
    PngTextProxy* png = nullptr;
    std::unique_ptr<CheckedProxy> proxy;  // outlives the output, whose destructor may write
    const std::unique_ptr<OIIO::ImageOutput> output(codecOf(writing.format).writer());
    if (writing.format == PictureFormat::Tiff) return tryWriteTiff(*output, writing, spec);
    if (writing.format == PictureFormat::Png) {
        auto texts = std::make_unique<PngTextProxy>(writing.temporary);
        png = texts.get();
        proxy = std::move(texts);
    } else {
        proxy = std::make_unique<CheckedProxy>(writing.temporary);
    }
    OIIO::Filesystem::IOProxy* const pointer = proxy.get();
    spec.attribute("oiio:ioproxy", OIIO::TypeDesc::PTR, &pointer);
    std::size_t sum = 0;
    const auto failed = [&] { return proxy->file().failed(); };
    Message problem;
    try {
        problem = tryWriteTo(*output, failed, writing, spec, sum);
    } catch (...) {
        if (png) avoidEmptyPng(*output, *png, spec);
        throw;
    }
    if (const std::string reason = proxy->file().finish(); !reason.empty()) return {reason, true};
    return {problem.isEmpty() ? tryToReadBack(writing, spec, spec.height - 1, sum) : problem};
}

/// Returns the first line of a text, with the temporary file called by its proper name.
std::string properlyNamed(std::string text, const PictureToWrite& writing) {
    const auto at = text.find(writing.temporary);
    if (at != std::string::npos) text.replace(at, writing.temporary.size(), writing.path);
    return text.substr(0, text.find('\n'));
}

/// Writes without the colour profile if the format's library refuses it, because that fails the whole file.
void writePicture(const PictureToWrite& writing, OIIO::ImageSpec spec) {
    Attempt attempt = tryWrite(writing, spec);
    if (!attempt.problem.isEmpty() && !attempt.disk && spec.find_attribute("ICCProfile")) {
        spec.erase_attribute("ICCProfile");
        attempt = tryWrite(writing, spec);
    }
    if (attempt.problem.isEmpty()) return;
    throw InputError(
        writing.path,
        {sentence("Core", "cannot be written: %1"),
         withTexts(attempt.problem, [&](const std::string& text) { return properlyNamed(text, writing); })});
}

/// OpenImageIO's own WebP rounds the colours of transparent pixels and drops the profile.
void writeWebpPicture(const PictureToWrite& writing, const OIIO::ImageSpec& spec) {
    Image whole = writing.picture;
    whole.data.reserve(whole.rowBytes() * static_cast<std::size_t>(whole.height));
    writing.strips([&](int, const Image& strip) {
        whole.data.insert(whole.data.end(), strip.data.begin(), strip.data.end());
        return true;
    });
    const std::string error = writeWebp(writing.temporary, whole, spec, writing.lossy);
    if (!error.empty()) throw InputError(writing.path, "cannot be written: " + error);
}

/// Takes the attributes that describe the source's colours and not its pixels. No name may contradict a
/// profile, and a profile of grey pictures becomes one of colours if the picture has become coloured.
void takeAttributes(PictureFormat format, const Image& image, const OIIO::ImageSpec& from,
                    OIIO::ImageSpec& to) {
    for (const OIIO::ParamValue& value : from.extra_attribs)
        if (!describesStorage(value.name().string())) to.extra_attribs.add_or_replace(value);
    const OIIO::ParamValue* profile = to.find_attribute("ICCProfile");
    if (!profile) return;
    for (const char* name : {"oiio:ColorSpace", "oiio:Gamma", "Exif:ColorSpace"}) to.erase_attribute(name);
    profile = to.find_attribute("ICCProfile");
    if (!profileFits(*profile, image.colours())) {
        const std::vector<std::byte> coloured = colouredProfile(*profile);
        to.erase_attribute("ICCProfile");
        if (!coloured.empty())
            to.attribute("ICCProfile",
                         OIIO::TypeDesc(OIIO::TypeDesc::UINT8, static_cast<int>(coloured.size())),
                         coloured.data());
    }
    dropOddProfile(format, to);
}

}  // namespace

OIIO::ImageSpec fileSpec(PictureFormat format, const Image& image) {
    OIIO::ImageSpec spec(image.width, image.height, image.channels, fileType(image.type));
    if (image.colours() == 1) spec.channelnames[0] = "Y";
    if (image.alpha) spec.channelnames.back() = "A";
    spec.alpha_channel = image.alpha ? image.channels - 1 : -1;
    const OIIO::ImageSpec source =
        unpacked(image.metadata ? fileMetadata(image)->description : std::string());
    takeAttributes(format, image, source, spec);
    setPlace(format, image, source, spec);
    if (image.alpha && image.unassociated) spec.attribute("oiio:UnassociatedAlpha", 1);
    const std::string compression = codecOf(format).compression;
    if (!compression.empty()) spec.attribute("compression", compression);
    if (isLarge(image)) {
        if (format == PictureFormat::Png) spec.attribute("png:compressionLevel", kQuickPng);
        if (format == PictureFormat::Tiff) spec.attribute("compression", kQuickZip);
    }
    if (format == PictureFormat::Jpeg) spec.attribute("jpeg:subsampling", "4:4:4");
    // The time of writing, which these libraries would put in, would make of the same picture another file.
    const bool isDated = format == PictureFormat::Tiff || format == PictureFormat::Exr;
    if (isDated && !spec.find_attribute("DateTime")) spec.attribute("DateTime", "");
    return spec;
}

void writeStored(const PictureToWrite& writing) {
    OIIO::ImageSpec spec = fileSpec(writing.format, writing.picture);
    if (!writing.channelNames.empty()) {
        spec.channelnames = writing.channelNames;
        spec.alpha_channel = 3;  // of the first picture
    }
    if (!codecOf(writing.format).writer)
        writeWebpPicture(writing, spec);
    else
        writePicture(writing, spec);
}

}  // namespace wend
