#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/base/message.h"

namespace wend {

enum class PixelType { UInt8, UInt16, Half, Float };

/// Pixels from (x, y) on.
struct PixelBox {
    int x = 0, y = 0, width = 0, height = 0;

    /// Returns the part within a picture of that size.
    PixelBox within(int pictureWidth, int pictureHeight) const;
    bool contains(const PixelBox& box) const;
    bool operator==(const PixelBox&) const = default;
};

/// The place of a picture's first pixel in its frame, the picture from which it was made. Without a size the
/// picture is a frame of its own.
struct CanvasPlace {
    int x = 0, y = 0, frameWidth = 0, frameHeight = 0;

    bool isOwn() const { return frameWidth == 0; }
};

/// A picture in memory in its own depth, interleaved, rows top to bottom. Alpha, if any, is the last channel
/// and the colours are associated (premultiplied) in memory unless `unassociated`: then they are as in the
/// file. One to four channels: gray, gray and alpha, RGB, RGBA.
struct Image {
    int width = 0, height = 0, channels = 0;
    PixelType type = PixelType::UInt8;
    bool alpha = false;         // the last channel is alpha
    bool unassociated = false;  // colours are not multiplied with alpha (PNG, TIFF with that flag)
    std::vector<std::byte> data;
    /// ICC profile, resolution, text: everything that the format carried, in the form of its reader.
    struct Metadata {
        std::vector<std::byte> iccProfile;  // empty without one
        bool isOfExr = false;               // it was made of what EXR holds: chromaticities of linear light
        PixelBox stored;                    // the part that the file held of its display window; empty: all
        std::vector<std::string> leftOut;   // names of channels that were not read
        std::vector<std::string> pictures;  // "NAME: 640 x 480" of all in the file, if there are several
        virtual ~Metadata() = default;
    };
    std::shared_ptr<const Metadata> metadata;
    CanvasPlace place = {};

    std::size_t pixelBytes() const;
    std::size_t rowBytes() const { return pixelBytes() * static_cast<std::size_t>(width); }
    int colours() const { return alpha ? channels - 1 : channels; }
    const std::byte* row(int y) const { return data.data() + rowBytes() * static_cast<std::size_t>(y); }
    /// Makes pixels of zeros.
    void makePixels();
    /// Reserves memory without initializing it: for large pictures in huge pages if available, because
    /// faulting in small ones would take longer than painting.
    void reservePixels();
    std::byte* row(int y) { return data.data() + rowBytes() * static_cast<std::size_t>(y); }
    std::vector<std::byte> iccProfile() const {
        return metadata ? metadata->iccProfile : std::vector<std::byte>();
    }
};

/// The largest picture that is read or made, in millions of pixels.
inline constexpr double kMaxMegapixels = 400;

/// Reads the formats of pictureFormat(), first picture of several, upright as its orientation tag says. The
/// picture is the file's display window: what the file does not store of it is zero, and what it stores
/// beyond is cut off. `notices` receives what the user should know: what was left out or had to be decided,
/// and numbers that are not finite. Throws InputError(path, why) for missing, empty, truncated, corrupt files
/// and for more than `maxMegapixels`.
Image readImage(const std::string& path, double maxMegapixels = kMaxMegapixels,
                std::vector<Message>* notices = nullptr);

/// Does the same for one layer of a file with layers, without the opacity and the place that the file gives
/// it. Throws InputError(path, why) if there is no such layer.
Image readLayer(const std::string& path, const std::string& layer, std::vector<Message>* notices = nullptr);

/// Writes by extension (png, tif, exr, jpg, webp …), whole or not at all; depth is converted to the nearest
/// supported one; without alpha in the format the picture is placed on white. Throws InputError.
void writeImage(const std::string& path, const Image& image);

/// Makes rows: as many as `strip` has, from `top` on. The strip has the picture's layout and zeros.
using MakeRows = std::function<void(int top, Image& strip)>;

/// Writes a picture (`header`: without pixels) whose rows are made while others are written, in strips of
/// `stripRows` from top to bottom, on another thread. Exceptions of `makeRows` are rethrown, and nothing is
/// written then. It may be called again for the same rows.
void writeImage(const std::string& path, const Image& header, int stripRows, const MakeRows& makeRows);

/// Returns whether writeImage() supports the extension.
bool canWriteImage(const std::string& path);

/// Reads size, type and channels without the pixels, and the list of layers.
Image readImageHeader(const std::string& path);

}  // namespace wend
