#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "core/base/message.h"
#include "warp/colour_space.h"
#include "warp/film.h"
#include "warp/image.h"
#include "warp/picture_format.h"
#include "warp/picture_metadata.h"

namespace wend {

/// A picture's file. Where `bytes` has any, they are read in its place.
struct PictureSource {
    std::string path;
    PictureFormat format;
    std::string bytes = {};
    std::optional<ColourSpace> colours = {};  // that take the place of what the format's library says
    std::vector<PictureLayer> layers = {};    // that the file says are merged in the picture
    bool namesExtraSamples = true;            // false of a TIFF that does not say what follows its colours
    bool hasProfile = false;                  // of a PNG, whose library does not report one that it drops
    bool isInverted = false;                  // white is 0, which the bytes do not say
    std::optional<int> page = {};  // of several pictures; without: the first, as the file's picture
};

/// A picture as it is stored in its file, how an EXIF tag asks to turn it (upright()), and notices for the
/// user.
struct StoredPicture {
    Image image;
    int orientation = 1;
    std::vector<Message> notices = {};
};

/// Returns the notice about a file with several pictures.
inline Message severalPictures(unsigned long long count) {
    return {sentence("Core", "has %1 pictures (pages, frames or parts): the first one is read"), count};
}

/// Returns the notice about a file with several layers.
inline Message flattenedLayers(std::size_t count) {
    return {sentence("Core", "has %1 layers: opened flattened"), count};
}

/// Receives a picture's pixels while they are read.
class PixelSink {
  public:
    virtual ~PixelSink() = default;
    /// Receives the picture without its pixels, before these. Returns room for that many rows.
    virtual std::byte* begin(const Image& header, int rows) = 0;
    /// Called when the next rows are in the buffer.
    virtual void take(int rows) = 0;
};

/// Takes the rows from `top` on; false once no more are wanted.
using TakeRows = std::function<bool(int top, const Image& strip)>;

/// A picture that is written to a file.
struct PictureToWrite {
    PictureFormat format;
    std::string path, temporary;  // the name to speak of, and the file that is written
    Image picture;                // in the file's layout, without pixels
    /// Hands over all strips from top to bottom, until one is refused: then it returns false. It can be asked
    /// again.
    std::function<bool(const TakeRows&)> strips;
    bool lossy =
        false;  // of WebP: details that are hardly visible are dropped, for a file of a fraction of the size
    std::vector<std::string> channelNames =
        {};  // of an EXR with more than one picture; empty: the usual ones
};

/// A film that is written to a file.
struct FilmToWrite {
    std::string path, file;  // the name to speak of, and the file that is written
    FilmOptions options;
};

/// Takes a film's frames one by one.
class FilmEncoder {
  public:
    virtual ~FilmEncoder() = default;
    /// 8 bits deep with alpha, the colours not associated, or without alpha if the format has none; of the
    /// first one's size and with its metadata. Throws InputError.
    virtual void add(const Image& frame) = 0;
    /// Completes the file. Throws InputError.
    virtual void finish() = 0;
};

/// The work of OpenImageIO: readers in wend-picture (readPicture()), writers in the program. It depends on
/// two hundred other libraries, and linking them takes ten times as long as starting all the rest of Wend, so
/// they are in a module beside the program, which the first picture loads. No format is guessed, and only the
/// named files are read.
class PictureLibrary {
  public:
    virtual ~PictureLibrary() = default;

    /// Reads a picture without its pixels. Throws InputError.
    virtual StoredPicture readHeader(const PictureSource& source) const = 0;
    /// Reads a picture, whose pixels go to `sink`. Throws InputError, and for more than `maxMegapixels`.
    virtual StoredPicture read(const PictureSource& source, double maxMegapixels, PixelSink& sink) const = 0;
    /// Throws InputError(path, why) if the file is not what was handed over.
    virtual void write(const PictureToWrite& writing) const = 0;
    /// Makes an animated WebP, which is in memory until it is complete. Throws InputError(path, why) for a
    /// rate that the format cannot have.
    virtual std::unique_ptr<FilmEncoder> film(const FilmToWrite& writing) const = 0;
};

/// Loads the module when it is asked for the first time, on behalf of the picture in `path`. Throws
/// InputError and OutOfMemory with that name.
const PictureLibrary& pictureLibrary(const std::string& path);

/// Begins to load the module on another thread, for a picture that will be written soon: a failure is
/// reported then. Does nothing under a limit on addresses, where others may need them first.
std::jthread loadPictureLibrary();

/// OpenImageIO looks for plug-ins once, where the environment says, and loads what it finds (already to learn
/// whether an attribute's prefix is a format's name). The module makes it look nowhere, for which it changes
/// the environment for a moment. If that names any place, this loads the module: call it before any thread
/// begins.
void lookForNoPlugins();

}  // namespace wend
