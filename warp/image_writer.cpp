#include <algorithm>
#include <array>
#include <filesystem>
#include <functional>
#include <future>
#include <optional>
#include <string_view>

#include "core/mesh/error.h"
#include "core/mesh/file_name.h"
#include "core/mesh/safe_file.h"
#include "warp/checked_proxy.h"
#include "warp/convert.h"
#include "warp/image_formats.h"
#include "warp/image_metadata.h"
#include "warp/picture_codecs.h"
#include "warp/webp.h"

namespace wend {
namespace {

enum class Association { Unassociated, Associated, Either };

/// What a format can hold.
struct Format {
    PictureCodec codec;
    std::array<std::string_view, 3> extensions;
    std::array<bool, 4> types;  // UInt8, UInt16, Half, Float
    bool gray, alpha, grayAlpha;
    Association association;
    std::string_view compression;
};

constexpr std::array formats{
    Format{kPng, {".png"}, {true, true, false, false}, true, true, true, Association::Unassociated, ""},
    Format{kTiff, {".tif", ".tiff"}, {true, true, true, true}, true, true, true, Association::Either, "zip"},
    Format{kExr, {".exr"}, {false, false, true, true}, true, true, true, Association::Associated, "zip"},
    Format{kJpeg,
           {".jpg", ".jpeg", ".jpe"},
           {true, false, false, false},
           true,
           false,
           false,
           Association::Either,
           "jpeg:95"},
    Format{kWebp, {".webp"}, {true, false, false, false}, false, true, false, Association::Unassociated, ""},
    Format{kBmp, {".bmp"}, {true, false, false, false}, true, true, false, Association::Unassociated, ""},
    Format{kTga, {".tga"}, {true, false, false, false}, true, true, false, Association::Unassociated, "rle"},
    Format{kJpeg2000, {".jp2"}, {true, true, false, false}, true, false, false, Association::Either, ""},
    Format{kPnm, {".ppm", ".pnm"}, {true, false, false, false}, true, false, false, Association::Either, ""},
    Format{kHdr, {".hdr"}, {false, false, false, true}, false, false, false, Association::Either, ""},
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

/// Of a large picture, the usual level of compression takes five times the time for 6 % less.
constexpr const char* kQuickZip = "zip:4";
constexpr int kQuickPng = 4;

bool isLarge(const Image& image) {
    return image.width * 1e-6 * image.height > 16;
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
    if (isLarge(image)) {
        if (format.extensions[0] == ".png") spec.attribute("png:compressionLevel", kQuickPng);
        if (format.extensions[0] == ".tif") spec.attribute("compression", kQuickZip);
    }
    if (format.compression.starts_with("jpeg")) spec.attribute("jpeg:subsampling", "4:4:4");
    // The time of writing, which these libraries would put in, would make of the same picture another file.
    const bool isDated = format.extensions[0] == ".tif" || format.extensions[0] == ".exr";
    if (isDated && !spec.find_attribute("DateTime")) spec.attribute("DateTime", "");
    return spec;
}

/// A picture's strips in the file's layout, each made while the one before is written.
class Strips {
  public:
    Strips(const Image& picture, const PixelLayout& layout, int rows, const MakeRows& makeRows)
        : m_picture(picture), m_layout(layout), m_rows(rows), m_makeRows(makeRows) {}

    /// Calls write(top, strip) from top to bottom until it returns false.
    template <typename Write>
    bool forEach(Write&& write) {
        makeNext();
        for (int top = 0; top < m_picture.height; top += m_rows) {
            const Image strip = m_next.get();
            makeNext();
            if (!write(top, strip)) return false;
        }
        return true;
    }

  private:
    void makeNext() {
        if (m_begin >= m_picture.height) return;
        m_next = std::async(std::launch::async, [this, top = m_begin] { return made(top); });
        m_begin += m_rows;
    }

    Image made(int top) const {
        Image strip = m_picture;
        strip.height = std::min(m_rows, m_picture.height - top);
        strip.makePixels();
        m_makeRows(top, strip);
        return m_layout == layoutOf(strip) ? std::move(strip) : converted(strip, m_layout);
    }

    const Image& m_picture;
    PixelLayout m_layout;
    int m_rows, m_begin = 0;
    const MakeRows& m_makeRows;
    std::future<Image> m_next;  // its end waits for the work
};

/// A picture on its way into a file.
struct Writing {
    const Format& format;
    std::string path, temporary;
    Image picture;  // in the file's layout, without pixels
    std::function<Strips()> strips;
};

/// How an attempt to write ended: the reason of a failure, empty on success, and whether it is the disk's.
struct Attempt {
    std::string problem;
    bool disk = false;
};

using Bytes = std::string_view;

std::size_t mixed(std::size_t sum, Bytes bytes) {
    return sum * 31 + std::hash<Bytes>()(bytes);
}

/// Writes all rows; `failed` tells of what the format's library does not see. `sum` gets that of the rows.
template <typename Failed>
std::string tryWriteTo(OIIO::ImageOutput& output, const Failed& failed, const Writing& writing,
                       const OIIO::ImageSpec& spec, std::size_t& sum) {
    if (!output.open(writing.temporary, spec)) return "cannot be opened for writing: " + output.geterror();
    const bool written = writing.strips().forEach([&](int top, const Image& strip) {
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
    return error.empty() ? "the disk may be full" : error;
}

/// What is wrong with a finished file when it is opened again and its rows from the `first` on are read;
/// empty if nothing is. Only the reader of its own format may look at it. `sum` gets that of the rows.
std::string tryToReadBack(const Writing& writing, const OIIO::ImageSpec& spec, int first, std::size_t& sum) {
    const std::unique_ptr<OIIO::ImageInput> input(writing.format.codec.reader());
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

/// libtiff tells of most that goes wrong, but not of all when it closes; and what it writes cannot go through
/// a file of ours, since OpenImageIO then does not let it read what it has written. All pixels are compared.
Attempt tryWriteTiff(OIIO::ImageOutput& output, const Writing& writing, const OIIO::ImageSpec& spec) {
    std::size_t written = 0, read = 0;
    std::string problem = tryWriteTo(
        output, [] { return false; }, writing, spec, written);
    if (problem.empty()) problem = tryToReadBack(writing, spec, 0, read);
    if (problem.empty() && written != read) problem = "is another picture when it is read again";
    return {problem};
}

/// None of the formats' libraries tells of a full disk in every case, and that of JPEG ends the process: what
/// they write goes through a file that looks.
Attempt tryWrite(const Writing& writing, OIIO::ImageSpec spec) {
    std::optional<CheckedProxy> proxy;  // outlives the output, whose end may write
    const std::unique_ptr<OIIO::ImageOutput> output(writing.format.codec.writer());
    if (std::string_view(output->format_name()) == "tiff") return tryWriteTiff(*output, writing, spec);
    OIIO::Filesystem::IOProxy* const pointer = &proxy.emplace(writing.temporary);
    spec.attribute("oiio:ioproxy", OIIO::TypeDesc::PTR, &pointer);
    std::size_t sum = 0;
    const auto failed = [&] { return proxy->file().failed(); };
    const std::string problem = tryWriteTo(*output, failed, writing, spec, sum);
    if (const std::string reason = proxy->file().finish(); !reason.empty()) return {reason, true};
    return {problem.empty() ? tryToReadBack(writing, spec, spec.height - 1, sum) : problem};
}

/// `text` with the temporary file called by its proper name.
std::string properlyNamed(std::string text, const Writing& writing) {
    const auto at = text.find(writing.temporary);
    return at == std::string::npos ? text : text.replace(at, writing.temporary.size(), writing.path);
}

/// A colour profile that the format's library refuses fails the whole file: better the picture without it.
void writePicture(const Writing& writing, OIIO::ImageSpec spec) {
    Attempt attempt = tryWrite(writing, spec);
    if (!attempt.problem.empty() && !attempt.disk && spec.find_attribute("ICCProfile")) {
        spec.erase_attribute("ICCProfile");
        attempt = tryWrite(writing, spec);
    }
    if (attempt.problem.empty()) return;
    const std::string problem = properlyNamed(attempt.problem, writing);
    throw InputError(writing.path, "cannot be written: " + problem.substr(0, problem.find('\n')));
}

/// OpenImageIO's own WebP rounds the colours of transparent pixels and drops the profile.
void writeWebpPicture(const Writing& writing, const OIIO::ImageSpec& spec) {
    Image whole = writing.picture;
    whole.data.reserve(whole.rowBytes() * static_cast<std::size_t>(whole.height));
    writing.strips().forEach([&](int, const Image& strip) {
        whole.data.insert(whole.data.end(), strip.data.begin(), strip.data.end());
        return true;
    });
    const std::string error = writeWebp(writing.temporary, whole, spec);
    if (!error.empty()) throw InputError(writing.path, "cannot be written: " + error);
}

Image withLayout(const Image& header, const PixelLayout& layout) {
    return {header.width, header.height,  layout.channels, layout.type, layout.alpha, layout.unassociated,
            {},           header.metadata};
}

}  // namespace

bool canWriteImage(const std::string& path) {
    return findFormat(lowerExtension(path)) != nullptr;
}

bool holdsType(const std::string& path, PixelType type) {
    const Format* format = findFormat(lowerExtension(path));
    return format && format->types[static_cast<std::size_t>(type)];
}

bool holdsAlpha(const std::string& path) {
    const Format* format = findFormat(lowerExtension(path));
    return format && format->alpha;
}

void writeImage(const std::string& path, const Image& header, int stripRows, const MakeRows& makeRows) {
    const Format& format = formatOf(path);
    if (header.width < 1 || header.height < 1) throw InputError(path, "there are no pixels to write");
    // OpenJPEG's encoder halves a picture five times, and writes nothing at all of a smaller one.
    constexpr int kMinJpeg2000 = 32;
    if (format.extensions[0] == ".jp2" && std::min(header.width, header.height) < kMinJpeg2000)
        throw InputError(path, "pictures of less than 32 pixels a side cannot be written as .jp2");
    const PixelLayout layout = fileLayout(format, header);
    writeWhole(path, [&](const std::string& temporary) {
        const Writing writing{format, path, temporary, withLayout(header, layout),
                              [&] { return Strips(header, layout, stripRows, makeRows); }};
        const OIIO::ImageSpec spec = fileSpec(format, writing.picture);
        if (!format.codec.writer)
            writeWebpPicture(writing, spec);
        else
            writePicture(writing, spec);
    });
}

void writeImage(const std::string& path, const Image& image) {
    constexpr int kRows = 256;
    Image header{image.width,        image.height, image.channels, image.type, image.alpha,
                 image.unassociated, {},           image.metadata};
    writeImage(path, header, kRows, [&](int top, Image& strip) {
        std::copy_n(image.row(top), strip.data.size(), strip.data.data());
    });
}

}  // namespace wend
