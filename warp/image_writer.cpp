#include <algorithm>
#include <array>
#include <functional>
#include <future>
#include <string_view>

#include "core/base/error.h"
#include "core/base/file_name.h"
#include "core/base/safe_file.h"
#include "warp/convert.h"
#include "warp/image_formats.h"
#include "warp/picture_library.h"

namespace wend {
namespace {

enum class Association { Unassociated, Associated, Either };

/// Capabilities of a format.
struct Format {
    PictureFormat id;
    std::array<std::string_view, 3> extensions;
    std::array<bool, 4> types;  // UInt8, UInt16, Half, Float
    bool gray, alpha, grayAlpha;
    Association association;
    bool profile = false;
};

constexpr std::array formats{
    Format{PictureFormat::Png,
           {".png"},
           {true, true, false, false},
           true,
           true,
           true,
           Association::Unassociated,
           true},
    Format{PictureFormat::Tiff,
           {".tif", ".tiff"},
           {true, true, true, true},
           true,
           true,
           true,
           Association::Either,
           true},
    Format{
        PictureFormat::Exr, {".exr"}, {false, false, true, true}, true, true, true, Association::Associated},
    Format{PictureFormat::Jpeg,
           {".jpg", ".jpeg", ".jpe"},
           {true, false, false, false},
           true,
           false,
           false,
           Association::Either,
           true},
    Format{PictureFormat::Webp,
           {".webp"},
           {true, false, false, false},
           false,
           true,
           false,
           Association::Unassociated,
           true},
    Format{PictureFormat::Bmp,
           {".bmp"},
           {true, false, false, false},
           true,
           true,
           false,
           Association::Unassociated},
    Format{PictureFormat::Tga,
           {".tga"},
           {true, false, false, false},
           true,
           true,
           false,
           Association::Unassociated},
    Format{PictureFormat::Jpeg2000,
           {".jp2"},
           {true, true, false, false},
           true,
           false,
           false,
           Association::Either},
    Format{PictureFormat::Pnm,
           {".ppm", ".pnm"},
           {true, false, false, false},
           true,
           false,
           false,
           Association::Either},
    Format{
        PictureFormat::Hdr, {".hdr"}, {false, false, false, true}, false, false, false, Association::Either},
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

/// Returns the nearest type that loses nothing, or else the format's widest: 16-bit integers need a float,
/// because a half does not hold them.
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

/// A picture's strips in the file's layout, each made while the one before is written.
class Strips {
  public:
    Strips(const Image& picture, const PixelLayout& layout, int rows, const MakeRows& makeRows)
        : m_picture(picture), m_layout(layout), m_rows(rows), m_makeRows(makeRows) {}

    /// Hands over strips from top to bottom until one is refused: false then.
    bool forEach(const TakeRows& take) {
        makeNext();
        for (int top = 0; top < m_picture.height; top += m_rows) {
            const Image strip = m_next.get();
            makeNext();
            if (!take(top, strip)) return false;
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

Image withLayout(const Image& header, const PixelLayout& layout) {
    return {header.width, header.height,   layout.channels, layout.type, layout.alpha, layout.unassociated,
            {},           header.metadata, header.place};
}

/// The box of the pixels that are not zero, as strips pass by.
class SeenBox {
  public:
    void add(int top, const Image& strip) {
        const std::size_t bytes = strip.pixelBytes();
        const auto isZero = [](std::byte byte) { return byte == std::byte(0); };
        for (int y = 0; y < strip.height; ++y) {
            const std::byte *begin = strip.row(y), *end = begin + strip.rowBytes();
            const std::byte* first = std::find_if_not(begin, end, isZero);
            if (first == end) continue;
            const std::byte* last = end;
            while (isZero(last[-1])) --last;
            const auto columns = [&](const std::byte* at) {
                return static_cast<int>(static_cast<std::size_t>(at - begin) / bytes);
            };
            take(columns(first), columns(last - 1) + 1, top + y);
        }
    }
    /// Returns the box of the visible pixels, or one pixel if there are none.
    PixelBox box() const {
        if (m_bottom < 0) return {0, 0, 1, 1};
        return {m_left, m_top, m_right - m_left, m_bottom + 1 - m_top};
    }

  private:
    void take(int left, int right, int y) {
        m_left = m_bottom < 0 ? left : std::min(m_left, left);
        m_right = std::max(m_right, right);
        if (m_bottom < 0) m_top = y;
        m_bottom = y;
    }

    int m_left = 0, m_top = 0, m_right = 0, m_bottom = -1;
};

/// Returns the part of a strip within a box of the picture; `top` becomes its first row's place in the box.
Image croppedTo(const PixelBox& box, const Image& strip, int& top) {
    Image part = strip;
    const int begin = std::max(top, box.y), end = std::min(top + strip.height, box.y + box.height);
    part.width = box.width, part.height = std::max(0, end - begin);
    part.data.clear();
    for (int y = begin; y < end; ++y) {
        const std::byte* from = strip.row(y - top) + strip.pixelBytes() * static_cast<std::size_t>(box.x);
        part.data.insert(part.data.end(), from, from + part.rowBytes());
    }
    top = begin - box.y;
    return part;
}

using ForStrips = std::function<bool(const TakeRows&)>;

/// Writes a part of an EXR picture if its source stored a part of its display window: the same part, unless
/// there are pixels beyond it that are not zero. The rows are made twice.
void keepWindow(const Image& header, const ForStrips& all, PictureToWrite& writing) {
    SeenBox seen;
    all([&](int top, const Image& strip) {
        seen.add(top, strip);
        return true;
    });
    const PixelBox stored = header.metadata->stored.within(header.width, header.height);
    const PixelBox box = stored.contains(seen.box()) ? stored : seen.box();
    Image& picture = writing.picture;
    picture.place = {box.x, box.y, picture.width, picture.height};
    picture.width = box.width, picture.height = box.height;
    writing.strips = [all, box](const TakeRows& take) {
        return all([&](int top, const Image& strip) {
            const Image part = croppedTo(box, strip, top);
            return part.height == 0 || take(top, part);
        });
    };
}

bool keepsWindow(const Format& format, const Image& header) {
    return format.id == PictureFormat::Exr && header.place.isOwn() && header.metadata &&
           header.metadata->stored.width > 0;
}

}  // namespace

bool canWriteImage(const std::string& path) {
    return findFormat(lowerExtension(path)) != nullptr;
}

bool holdsType(const std::string& path, PixelType type) {
    if (lowerExtension(path) == ".psd") return type == PixelType::UInt8 || type == PixelType::UInt16;
    const Format* format = findFormat(lowerExtension(path));
    return format && format->types[static_cast<std::size_t>(type)];
}

bool roundsNumbers(const std::string& path, PixelType type) {
    const std::string extension = lowerExtension(path);
    if (extension == ".psd" || extension == ".ora")
        return type == PixelType::Half || type == PixelType::Float;
    const Format* format = findFormat(extension);
    if (!format) return false;
    const PixelType written = nearestType(*format, type);
    if (written == type) return false;
    if (type == PixelType::UInt8) return false;
    return written != PixelType::Float || format->id == PictureFormat::Hdr;
}

bool losesNegativeLight(const std::string& path, const Image& image) {
    const Format* format = findFormat(lowerExtension(path));
    const bool isLight = image.type == PixelType::Half || image.type == PixelType::Float;
    if (!format || format->id != PictureFormat::Hdr || !isLight) return false;
    const auto channels = static_cast<std::size_t>(image.channels),
               colours = static_cast<std::size_t>(image.colours());
    std::vector<float> row(channels * static_cast<std::size_t>(image.width));
    for (int y = 0; y < image.height; ++y) {
        loadRow(image, y, row.data());
        for (std::size_t k = 0; k < row.size(); ++k)
            if (k % channels < colours && row[k] < 0) return true;
    }
    return false;
}

bool holdsAlpha(const std::string& path) {
    const Format* format = findFormat(lowerExtension(path));
    return format && format->alpha;
}

bool losesProfile(const std::string& path, const Image& image) {
    const Format* format = findFormat(lowerExtension(path));
    if (!format || format->profile || !image.metadata || image.metadata->iccProfile.empty()) return false;
    return format->id != PictureFormat::Exr || !image.metadata->isOfExr;
}

void writeImage(const std::string& path, const Image& header, int stripRows, const MakeRows& makeRows) {
    writeImage(path, header, stripRows, makeRows, false);
}

void writeImage(const std::string& path, const Image& header, int stripRows, const MakeRows& makeRows,
                bool lossy) {
    const Format& format = formatOf(path);
    if (header.width < 1 || header.height < 1) throw InputError(path, "there are no pixels to write");
    // OpenJPEG's encoder halves a picture five times, and writes nothing at all of a smaller one.
    constexpr int kMinJpeg2000 = 32;
    if (format.extensions[0] == ".jp2" && std::min(header.width, header.height) < kMinJpeg2000)
        throw InputError(path, "pictures of less than 32 pixels a side cannot be written as .jp2");
    const PixelLayout layout = fileLayout(format, header);
    const ForStrips strips = [&](const TakeRows& take) {
        return Strips(header, layout, stripRows, makeRows).forEach(take);
    };
    writeWhole(path, [&](const std::string& temporary) {
        PictureToWrite writing{format.id, path, temporary, withLayout(header, layout), strips, lossy};
        if (keepsWindow(format, header)) keepWindow(header, strips, writing);
        pictureLibrary(path).write(writing);
    });
}

void writeImage(const std::string& path, const Image& image) {
    constexpr int kRowsAtOnce = 256;
    Image header{image.width,        image.height, image.channels, image.type, image.alpha,
                 image.unassociated, {},           image.metadata, image.place};
    writeImage(path, header, kRowsAtOnce, [&](int top, Image& strip) {
        std::copy_n(image.row(top), strip.data.size(), strip.data.data());
    });
}

}  // namespace wend
