#include "warp/openimageio/reader.h"

#include <OpenImageIO/filesystem.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "core/mesh/error.h"
#include "warp/openimageio/icc_profile.h"
#include "warp/openimageio/image_metadata.h"
#include "warp/openimageio/picture_codecs.h"
#include "warp/openimageio/webp.h"

namespace wend {
namespace {

constexpr double kFarthest = 1e9;         // in pixels
constexpr int kCieLab = 8, kItuLab = 10;  // of TIFF's photometric interpretations, ICC's L*a*b* between them

/// The first line, which is the cause; what follows repeats it.
std::string firstLine(const std::string& text) {
    return text.substr(0, text.find('\n'));
}

bool isWebp(const OIIO::ImageInput& input) {
    return std::string_view(input.format_name()) == "webp";
}

/// The colours of a BMP are as in the file, whatever is asked for, and nothing says so.
bool isBmp(const OIIO::ImageInput& input) {
    return std::string_view(input.format_name()) == "bmp";
}

/// A reader of the file, or of the bytes in its place.
class OpenPicture {
  public:
    explicit OpenPicture(const PictureSource& source)
        : m_bytes(source.bytes.data(), source.bytes.size()), m_input(codecOf(source.format).reader()) {
        OIIO::ImageSpec hints, spec;
        hints.attribute("oiio:UnassociatedAlpha", 1);
        OIIO::Filesystem::IOProxy* const bytes = &m_bytes;
        if (!source.bytes.empty()) hints.attribute("oiio:ioproxy", OIIO::TypeDesc::PTR, &bytes);
        if (m_input->open(source.path, spec, hints)) return;
        const std::string reason = firstLine(m_input->geterror());
        throw InputError(source.path,
                         "cannot be read as a picture" + (reason.empty() ? reason : ": " + reason));
    }
    OIIO::ImageInput* operator->() const { return m_input.get(); }
    OIIO::ImageInput& operator*() const { return *m_input; }

  private:
    OIIO::Filesystem::IOMemReader m_bytes;
    std::unique_ptr<OIIO::ImageInput> m_input;
};

PixelType pixelType(const OIIO::TypeDesc& format) {
    switch (format.basetype) {
        case OIIO::TypeDesc::UINT8:
            return PixelType::UInt8;
        case OIIO::TypeDesc::UINT16:
            return PixelType::UInt16;
        case OIIO::TypeDesc::HALF:
            return PixelType::Half;
        default:
            return PixelType::Float;
    }
}

OIIO::TypeDesc typeDesc(PixelType type) {
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
    return OIIO::TypeDesc::FLOAT;
}

/// Colours, then alpha; what a file has beyond (depth, masks, other layers) is left out. Some readers of
/// OpenImageIO name an alpha channel that is not there (GIF: 4 of 4).
void chooseChannels(const OIIO::ImageSpec& spec, Image& image) {
    int alpha = spec.alpha_channel;
    if (alpha >= spec.nchannels) alpha = spec.nchannels % 2 == 0 ? spec.nchannels - 1 : -1;
    image.alpha = alpha == 1 || alpha == 3;
    image.channels = image.alpha ? alpha + 1 : (spec.nchannels < 3 ? 1 : 3);
    image.unassociated = image.alpha && spec.get_int_attribute("oiio:UnassociatedAlpha") != 0;
}

Image header(const OIIO::ImageSpec& spec) {
    Image image;
    image.width = spec.width, image.height = spec.height;
    image.type = pixelType(spec.format);
    chooseChannels(spec, image);
    auto metadata = std::make_shared<OpenImageIOMetadata>();
    metadata->spec = spec;
    if (const OIIO::ParamValue* profile = spec.find_attribute("ICCProfile")) {
        const auto* bytes = static_cast<const std::byte*>(profile->data());
        if (profileFits(*profile, image.colours()))
            metadata->iccProfile.assign(bytes, bytes + profile->datasize());
        else
            metadata->spec.erase_attribute("ICCProfile");
    }
    metadata->spec.attribute("Orientation", 1);
    image.metadata = std::move(metadata);
    return image;
}

void requireSensible(const std::string& path, const OIIO::ImageSpec& spec, double maxMegapixels) {
    if (spec.width < 1 || spec.height < 1 || spec.nchannels < 1) throw InputError(path, "has no pixels");
    if (spec.depth > 1) throw InputError(path, "is a volume, not a picture");
    // OpenImageIO adds the rows of a strip to such places, in 32 bits.
    for (const int place : {spec.x, spec.y, spec.full_x, spec.full_y})
        if (std::abs(static_cast<double>(place)) > kFarthest)
            throw InputError(path, "lies more than a thousand million pixels from its origin");
    const int colours = spec.get_int_attribute("tiff:PhotometricInterpretation", -1);
    if (colours >= kCieLab && colours <= kItuLab)
        throw InputError(path, "has L*a*b* colours, which are not read; save it with RGB colours");
    const double megapixels = spec.width * 1e-6 * spec.height;
    if (megapixels > maxMegapixels) {
        std::ostringstream text;
        text.imbue(std::locale::classic());
        text << "has " << spec.width << " x " << spec.height << " pixels, more than " << maxMegapixels
             << " million";
        throw InputError(path, text.str());
    }
}

/// What libjpeg finds and repairs without loss: padding between segments, unusual but harmless scan
/// parameters.
bool harmless(const std::string& error) {
    return error.find("extraneous bytes before marker") != std::string::npos ||
           error.find("Invalid SOS parameters") != std::string::npos;
}

/// OpenImageIO returns true for truncated TIFF and corrupt JPEG files: only the error text tells.
void requireSuccess(const std::string& path, OIIO::ImageInput& input, bool success) {
    const std::string error = firstLine(input.geterror());
    if (success && (error.empty() || harmless(error))) return;
    throw InputError(path, "is truncated or corrupt" + (error.empty() ? error : ": " + error));
}

/// In strips, so that memory is taken only as real data comes.
void readStrips(const std::string& path, OIIO::ImageInput& input, Image& image, void (*goOn)()) {
    const OIIO::ImageSpec spec = input.spec();
    const int strip = 64;
    image.reservePixels();
    for (int y = 0; y < image.height; y += strip) {
        goOn();
        const int end = std::min(y + strip, image.height);
        image.data.resize(image.rowBytes() * static_cast<std::size_t>(end));
        const bool success = input.read_scanlines(0, 0, spec.y + y, spec.y + end, spec.z, 0, image.channels,
                                                  typeDesc(image.type), image.row(y));
        requireSuccess(path, input, success);
    }
}

void readPixels(const std::string& path, OIIO::ImageInput& input, Image& image, void (*goOn)()) {
    if (isWebp(input)) {
        if (readWebp(path, image)) return;
        image.unassociated = false;  // OpenImageIO's frames of animations are associated
    }
    if (input.spec().tile_width == 0) return readStrips(path, input, image, goOn);
    image.makePixels();
    const bool success = input.read_image(0, 0, 0, image.channels, typeDesc(image.type), image.data.data());
    requireSuccess(path, input, success);
}

/// What the file says, with what OpenImageIO leaves to us: WebP's metadata, and one name for the inch.
OIIO::ImageSpec specOf(const std::string& path, const OIIO::ImageInput& input) {
    OIIO::ImageSpec spec = input.spec();
    if (spec.get_string_attribute("ResolutionUnit") == "inch") spec.attribute("ResolutionUnit", "in");
    if (isBmp(input)) spec.attribute("oiio:UnassociatedAlpha", 1);
    if (!isWebp(input)) return spec;
    readWebpMetadata(path, spec);
    spec.attribute("oiio:UnassociatedAlpha", 1);
    return spec;
}

int orientationOf(const OIIO::ImageSpec& spec) {
    return spec.get_int_attribute("Orientation", 1);
}

}  // namespace

StoredPicture readStoredHeader(const PictureSource& source) {
    const OpenPicture input(source);
    const OIIO::ImageSpec spec = specOf(source.path, *input);
    return {header(spec), orientationOf(spec)};
}

StoredPicture readStored(const PictureSource& source, double maxMegapixels, void (*goOn)()) {
    const std::string& path = source.path;
    const OpenPicture input(source);
    requireSensible(path, input->spec(), maxMegapixels);
    const OIIO::ImageSpec spec = specOf(path, *input);
    StoredPicture stored{header(spec), orientationOf(spec)};
    readPixels(path, *input, stored.image, goOn);
    return stored;
}

}  // namespace wend
