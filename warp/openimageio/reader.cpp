#include "warp/openimageio/reader.h"

#include <OpenImageIO/filesystem.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "core/base/error.h"
#include "core/base/number_text.h"
#include "warp/openimageio/icc_profile.h"
#include "warp/openimageio/image_metadata.h"
#include "warp/openimageio/picture_codecs.h"
#include "warp/openimageio/png_text.h"
#include "warp/openimageio/webp.h"
#include "warp/pixels.h"

namespace wend {
namespace {

constexpr double kFarthest = 1e9;         // in pixels
constexpr int kStrip = 64;                // rows that are read at once
constexpr int kCieLab = 8, kItuLab = 10;  // of TIFF's photometric interpretations, ICC's L*a*b* between them

/// Returns the first line, which is the cause; the others repeat it.
std::string firstLine(const std::string& text) {
    return text.substr(0, text.find('\n'));
}

bool isWebp(const OIIO::ImageInput& input) {
    return std::string_view(input.format_name()) == "webp";
}

/// Returns whether the reader silently leaves the colours as they are in the file, not multiplied with alpha.
bool keepsColours(const OIIO::ImageInput& input) {
    constexpr std::array<std::string_view, 7> kThose{"bmp", "dds", "dpx", "ico", "jpeg2000", "psd", "sgi"};
    return std::ranges::find(kThose, std::string_view(input.format_name())) != kThose.end();
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
        if (m_input->open(source.path, spec, hints) && m_input->seek_subimage(source.page.value_or(0), 0))
            return;
        const std::string reason = firstLine(m_input->geterror());
        if (reason.empty()) throw InputError(source.path, "cannot be read as a picture");
        throw InputError(source.path, {sentence("Core", "cannot be read as a picture: %1"), reason});
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

/// Returns the index of the undeclared sample after the colours of a TIFF, which is alpha in the files of
/// many programs; −1 if there is none.
int undeclaredAlpha(const OIIO::ImageSpec& spec, bool namesExtraSamples) {
    const int photometric = spec.get_int_attribute("tiff:PhotometricInterpretation", -1);
    const int colours = photometric == 0 || photometric == 1 ? 1 : photometric == 2 ? 3 : -1;
    const bool isUndeclared = spec.alpha_channel < 0 || !namesExtraSamples;
    return isUndeclared && spec.nchannels > colours ? colours : -1;
}

/// Chooses the colours, then alpha; what a file has beyond (depth, masks, other layers) is left out. Some
/// readers of OpenImageIO name an alpha channel that is not there (GIF: 4 of 4).
void chooseChannels(const OIIO::ImageSpec& spec, bool namesExtraSamples, Image& image) {
    int alpha = spec.alpha_channel;
    if (alpha >= spec.nchannels) alpha = spec.nchannels % 2 == 0 ? spec.nchannels - 1 : -1;
    const int undeclared = undeclaredAlpha(spec, namesExtraSamples);
    if (undeclared > 0) alpha = undeclared;
    image.alpha = alpha == 1 || alpha == 3;
    image.channels = image.alpha ? alpha + 1 : (spec.nchannels < 3 ? 1 : 3);
    image.unassociated =
        image.alpha && (undeclared > 0 || spec.get_int_attribute("oiio:UnassociatedAlpha") != 0);
}

std::vector<std::string> channelsLeftOut(const OIIO::ImageSpec& spec, int read) {
    std::vector<std::string> names;
    for (int c = read; c < spec.nchannels; ++c)
        names.push_back(spec.channelnames[static_cast<std::size_t>(c)]);
    return names;
}

/// Returns whether pixel coordinates are those of a display window that the file names.
bool hasDisplayWindow(const OIIO::ImageSpec& spec, PictureFormat format) {
    const bool isNamed =
        format == PictureFormat::Exr || (format == PictureFormat::Tiff && spec.full_width != spec.width);
    return isNamed && spec.full_width > 0 && spec.full_height > 0 &&
           (spec.x != spec.full_x || spec.y != spec.full_y || spec.width != spec.full_width ||
            spec.height != spec.full_height);
}

/// Returns the place of the stored pixels in the picture, which may extend beyond it.
PixelBox storedBox(const OIIO::ImageSpec& spec) {
    return {spec.x - spec.full_x, spec.y - spec.full_y, spec.width, spec.height};
}

void setProfile(OIIO::ImageSpec& spec, const std::vector<std::byte>& profile) {
    spec.attribute("ICCProfile", OIIO::TypeDesc(OIIO::TypeDesc::UINT8, static_cast<int>(profile.size())),
                   profile.data());
}

/// Returns the colours that an EXR file names, whose light is linear.
std::optional<ColourSpace> chromaticitiesOf(const OIIO::ImageSpec& spec) {
    const OIIO::ParamValue* value = spec.find_attribute("chromaticities");
    if (!value || value->type().basetype != OIIO::TypeDesc::FLOAT ||
        value->type().basevalues() * value->nvalues() != 8)
        return std::nullopt;
    ColourSpace space;
    const auto* numbers = static_cast<const float*>(value->data());
    std::copy_n(numbers, 8, space.chromaticities.begin());
    space.curve = ColourSpace::Curve::Power;
    if (space.hasCommonColours()) return std::nullopt;
    return space;
}

/// Colours by chromaticities become a profile, which all formats hold that hold any; what an EXR file needs
/// stays beside it.
void takeColours(const std::optional<ColourSpace>& colours, int count, OIIO::ImageSpec& spec) {
    if (!colours) return;
    const std::vector<std::byte> profile = iccProfileOf(*colours, count < 3);
    if (profile.empty()) return;
    setProfile(spec, profile);
    std::array<float, 8> numbers{};
    std::transform(colours->chromaticities.begin(), colours->chromaticities.end(), numbers.begin(),
                   [](double value) { return static_cast<float>(value); });
    spec.attribute("chromaticities", OIIO::TypeDesc(OIIO::TypeDesc::FLOAT, 8), numbers.data());
}

StoredPicture header(const OIIO::ImageSpec& spec, const PictureSource& source) {
    StoredPicture stored;
    Image& image = stored.image;
    image.width = spec.width, image.height = spec.height;
    image.type = pixelType(spec.format);
    chooseChannels(spec, source.namesExtraSamples, image);
    auto metadata = std::make_shared<PictureMetadata>();
    OIIO::ImageSpec described = spec;
    if (hasDisplayWindow(spec, source.format)) {
        image.width = spec.full_width, image.height = spec.full_height;
        metadata->stored = storedBox(spec);
    }
    const auto exrColours = chromaticitiesOf(spec);
    metadata->isOfExr = exrColours.has_value();
    takeColours(source.colours ? source.colours : exrColours, image.colours(), described);
    const OIIO::ParamValue* profile = described.find_attribute("ICCProfile");
    if (profile && profileFits(*profile, image.colours())) {
        const auto* bytes = static_cast<const std::byte*>(profile->data());
        metadata->iccProfile.assign(bytes, bytes + profile->datasize());
    } else if (profile || source.hasProfile) {
        described.erase_attribute("ICCProfile");
        stored.notices.emplace_back(
            sentence("Core", "has a colour profile that does not fit its colours: it is left out"));
    }
    metadata->leftOut = channelsLeftOut(spec, image.channels);
    described.attribute("Orientation", 1);
    metadata->description = packed(described);
    image.metadata = std::move(metadata);
    stored.orientation = spec.get_int_attribute("Orientation", 1);
    return stored;
}

std::string joined(const std::vector<std::string>& names) {
    constexpr std::size_t kMost = 8;
    std::string text;
    for (std::size_t k = 0; k < std::min(names.size(), kMost); ++k) text += (k > 0 ? ", " : "") + names[k];
    return text + (names.size() > kMost ? " …" : "");
}

/// Adds notices of what the file has and the picture does not, or of what had to be decided.
void tellOfFile(const OIIO::ImageSpec& spec, bool namesExtraSamples, StoredPicture& stored) {
    const PictureMetadata& metadata = *fileMetadata(stored.image);
    if (undeclaredAlpha(spec, namesExtraSamples) > 0)
        stored.notices.emplace_back(
            sentence("Core", "has a channel of no declared kind after its colours: it is taken as alpha"));
    if (!metadata.leftOut.empty())
        stored.notices.emplace_back(sentence("Core", "has channels that are left out: %1"),
                                    joined(metadata.leftOut));
    if (const auto count = metadata.pictures.size(); count > 1)
        stored.notices.push_back(severalPictures(count));
    if (const auto count = metadata.layers.size(); count > 1)
        stored.notices.push_back(flattenedLayers(count));
    const PixelBox& box = metadata.stored;
    const PixelBox seen = box.within(stored.image.width, stored.image.height);
    if (box.width > 0 && (seen.width < box.width || seen.height < box.height))
        stored.notices.emplace_back(
            sentence("Core",
                     "reaches beyond its display window of %1 x %2 pixels: what lies outside is cut off"),
            stored.image.width, stored.image.height);
}

void requireSize(const std::string& path, int width, int height, double maxMegapixels) {
    if (width * 1e-6 * height <= maxMegapixels) return;
    throw InputError(path, {sentence("Core", "has %1 x %2 pixels, more than %3 million"), width, height,
                            numberText(maxMegapixels)});
}

void requireSensible(const std::string& path, const OIIO::ImageSpec& spec, PictureFormat format,
                     double maxMegapixels) {
    if (spec.width < 1 || spec.height < 1 || spec.nchannels < 1)
        throw InputError(path, sentence("Core", "has no pixels"));
    if (spec.depth > 1) throw InputError(path, sentence("Core", "is a volume, not a picture"));
    // OpenImageIO adds the rows of a strip to such places, in 32 bits.
    for (const int place : {spec.x, spec.y, spec.full_x, spec.full_y})
        if (std::abs(static_cast<double>(place)) > kFarthest)
            throw InputError(path, "lies more than a thousand million pixels from its origin");
    const int colours = spec.get_int_attribute("tiff:PhotometricInterpretation", -1);
    if (colours >= kCieLab && colours <= kItuLab)
        throw InputError(path, "has L*a*b* colours, which are not read; save it with RGB colours");
    requireSize(path, spec.width, spec.height, maxMegapixels);
    if (hasDisplayWindow(spec, format)) requireSize(path, spec.full_width, spec.full_height, maxMegapixels);
}

/// Returns whether libjpeg finds and repairs an error without loss: padding between segments, unusual but
/// harmless scan parameters.
bool harmless(const std::string& error) {
    return error.find("extraneous bytes before marker") != std::string::npos ||
           error.find("Invalid SOS parameters") != std::string::npos;
}

/// Throws on failure. OpenImageIO returns true for truncated TIFF and corrupt JPEG files, so only the error
/// text is reliable.
void requireSuccess(const std::string& path, OIIO::ImageInput& input, bool success) {
    const std::string error = firstLine(input.geterror());
    if (success && (error.empty() || harmless(error))) return;
    const Message what = sentence("Core", "is truncated or corrupt");
    throw InputError(path, error.empty() ? what : what + ": " + error);
}

/// Hands over a picture that was read as a whole.
void handOver(const Image& image, PixelSink& sink) {
    std::byte* const room = sink.begin(image, kStrip);
    for (int y = 0; y < image.height; y += kStrip) {
        const int rows = std::min(kStrip, image.height - y);
        std::copy_n(image.row(y), image.rowBytes() * static_cast<std::size_t>(rows), room);
        sink.take(rows);
    }
}

/// Inverts the colours of pixels; associated ones are inverted within their alpha.
void invert(const Image& image, std::size_t pixels, void* at) {
    withPixelType(image.type, [&](auto t) {
        using T = decltype(t);
        const auto full = static_cast<T>(kFull<T>);
        const auto channels = static_cast<std::size_t>(image.channels),
                   colours = static_cast<std::size_t>(image.colours());
        auto* value = static_cast<T*>(at);
        for (std::size_t p = 0; p < pixels; ++p, value += channels) {
            const T white = image.alpha && !image.unassociated ? value[colours] : full;
            for (std::size_t c = 0; c < colours; ++c)
                value[c] = value[c] > white ? T(0) : static_cast<T>(white - value[c]);
        }
    });
}

/// Reads rows from y on, of whole tiles if the file has any.
bool readRowsAsStored(OIIO::ImageInput& input, const OIIO::ImageSpec& spec, const Image& image, int y,
                      int end, void* pixels) {
    const OIIO::TypeDesc type = typeDesc(image.type);
    if (spec.tile_width == 0)
        return input.read_scanlines(input.current_subimage(), 0, spec.y + y, spec.y + end, spec.z, 0,
                                    image.channels, type, pixels);
    return input.read_tiles(input.current_subimage(), 0, spec.x, spec.x + spec.width, spec.y + y,
                            spec.y + end, spec.z, spec.z + 1, 0, image.channels, type, pixels);
}

bool readRows(const PictureSource& source, OIIO::ImageInput& input, const OIIO::ImageSpec& spec,
              const Image& image, int y, int end, void* pixels) {
    const bool isRead = readRowsAsStored(input, spec, image, y, end, pixels);
    if (source.isInverted)
        invert(image, static_cast<std::size_t>(end - y) * static_cast<std::size_t>(image.width), pixels);
    return isRead;
}

/// Reads in strips, so that memory is taken only as real data arrives.
void readStrips(const PictureSource& source, OIIO::ImageInput& input, const Image& image, PixelSink& sink) {
    const OIIO::ImageSpec spec = input.spec();
    const int strip = spec.tile_height > 0 ? spec.tile_height : kStrip;
    std::byte* const room = sink.begin(image, strip);
    for (int y = 0; y < image.height; y += strip) {
        const int end = std::min(y + strip, image.height);
        requireSuccess(source.path, input, readRows(source, input, spec, image, y, end, room));
        sink.take(end - y);
    }
}

/// Reads the stored pixels into their display window.
void readWindow(const PictureSource& source, OIIO::ImageInput& input, Image& image, PixelSink& sink) {
    const PixelBox box = image.metadata->stored;
    Image stored = image;
    stored.width = box.width, stored.height = box.height;
    stored.makePixels();
    const OIIO::ImageSpec spec = input.spec();
    requireSuccess(source.path, input,
                   readRows(source, input, spec, stored, 0, stored.height, stored.data.data()));
    image.makePixels();
    const PixelBox seen = box.within(image.width, image.height);
    const std::size_t bytes = image.pixelBytes();
    for (int y = seen.y; y < seen.y + seen.height; ++y)
        std::copy_n(stored.row(y - box.y) + bytes * static_cast<std::size_t>(seen.x - box.x),
                    bytes * static_cast<std::size_t>(seen.width),
                    image.row(y) + bytes * static_cast<std::size_t>(seen.x));
    handOver(image, sink);
    image.data = {};
}

void readPixels(const PictureSource& source, OIIO::ImageInput& input, Image& image, PixelSink& sink) {
    if (isWebp(input)) {
        if (readWebp(source.path, image)) {
            handOver(image, sink);
            image.data = {};
            return;
        }
        image.unassociated = false;  // OpenImageIO's frames of animations are associated
    }
    if (image.metadata->stored.width > 0)
        readWindow(source, input, image, sink);
    else
        readStrips(source, input, image, sink);
}

/// Converts the Latin-1 texts of a PNG file to UTF-8. OpenImageIO does not distinguish them from the others,
/// which are in UTF-8.
void makeTextsUtf8(OIIO::ImageSpec& spec) {
    for (OIIO::ParamValue& value : spec.extra_attribs)
        if (const std::string text = value.get_string(0);
            value.type() == OIIO::TypeString && !charactersOf(text))
            value = OIIO::ParamValue(value.name(), utf8OfLatin1(text));
}

/// Returns the file's description, completed by what OpenImageIO leaves to the caller: WebP's metadata, one
/// name for the inch, and one encoding of texts.
OIIO::ImageSpec specOf(const std::string& path, const OIIO::ImageInput& input) {
    OIIO::ImageSpec spec = input.spec();
    if (std::string_view(input.format_name()) == "png") makeTextsUtf8(spec);
    if (spec.get_string_attribute("ResolutionUnit") == "inch") spec.attribute("ResolutionUnit", "in");
    if (keepsColours(input)) spec.attribute("oiio:UnassociatedAlpha", 1);
    if (!isWebp(input)) return spec;
    readWebpMetadata(path, spec);
    spec.attribute("oiio:UnassociatedAlpha", 1);
    return spec;
}

/// Returns OpenImageIO's description of each picture in a file. A damaged one ends the list.
std::vector<OIIO::ImageSpec> specsIn(const PictureSource& source) {
    constexpr int kMost = 1000;
    std::vector<OIIO::ImageSpec> specs;
    const OpenPicture input(source);
    for (int k = 0; k < kMost && input->seek_subimage(k, 0); ++k) specs.push_back(input->spec());
    input->geterror();  // which is of no interest
    return specs;
}

/// Returns "NAME: 640 x 480" for each picture, if there are several.
std::vector<std::string> namesOf(const std::vector<OIIO::ImageSpec>& specs) {
    std::vector<std::string> list;
    for (const OIIO::ImageSpec& spec : specs) {
        const std::string name(spec.get_string_attribute("oiio:subimagename"));
        list.push_back((name.empty() ? std::to_string(list.size() + 1) : name) + ": " +
                       std::to_string(spec.width) + " x " + std::to_string(spec.height));
    }
    if (list.size() < 2) list.clear();
    return list;
}

std::vector<std::string> framesIn(const PictureSource& source) {
    std::vector<std::string> list;
    for (int k = 1, count = webpFrames(source.path); count > 1 && k <= count; ++k)
        list.push_back("frame " + std::to_string(k));
    return list;
}

void setPictures(const PictureSource& source, Image& image) {
    auto metadata = std::make_shared<PictureMetadata>(*fileMetadata(image));
    switch (source.format) {
        case PictureFormat::Webp:
            metadata->pictures = framesIn(source);
            break;
        case PictureFormat::Tiff:
            if (source.page) break;
            metadata->layers = source.layers;
            if (source.layers.empty()) metadata->pictures = namesOf(specsIn(source));
            break;
        case PictureFormat::Exr:
        case PictureFormat::Gif:
        case PictureFormat::Heif:
        case PictureFormat::Ico:
            metadata->pictures = namesOf(specsIn(source));
            break;
        default:
            metadata->layers = source.layers;
    }
    image.metadata = std::move(metadata);
}

}  // namespace

StoredPicture readStoredHeader(const PictureSource& source) {
    const OpenPicture input(source);
    StoredPicture stored = header(specOf(source.path, *input), source);
    auto metadata = std::make_shared<PictureMetadata>(*fileMetadata(stored.image));
    metadata->layers = source.layers;
    stored.image.metadata = std::move(metadata);
    return stored;
}

StoredPicture readStored(const PictureSource& source, double maxMegapixels, PixelSink& sink) {
    const std::string& path = source.path;
    const OpenPicture input(source);
    requireSensible(path, input->spec(), source.format, maxMegapixels);
    const OIIO::ImageSpec spec = specOf(path, *input);
    StoredPicture stored = header(spec, source);
    readPixels(source, *input, stored.image, sink);
    setPictures(source, stored.image);
    tellOfFile(spec, source.namesExtraSamples, stored);
    return stored;
}

}  // namespace wend
