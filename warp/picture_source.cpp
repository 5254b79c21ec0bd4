#include "warp/picture_source.h"

#include <cstdint>
#include <optional>

#include "core/base/error.h"
#include "warp/bmp_check.h"
#include "warp/layered_file.h"
#include "warp/metadata_check.h"
#include "warp/picture_format.h"
#include "warp/png_check.h"
#include "warp/png_colours.h"
#include "warp/psd_file.h"
#include "warp/svg_layers.h"
#include "warp/tga_check.h"
#include "warp/tiff_pages.h"

namespace wend {
namespace {

/// Describes what the format's library would not survive; empty if nothing is known.
std::string problemOf(const InputFile& file, PictureFormat format) {
    switch (format) {
        case PictureFormat::Bmp:
            return bmpProblem(file);
        case PictureFormat::Tga:
            return tgaProblem(file);
        default:
            return {};
    }
}

void tellOf(const PngExtras& extras, std::vector<Message>& notices) {
    if (extras.frames > 1) notices.push_back(severalPictures(extras.frames));
    if (!extras.unknownColours.empty())
        notices.push_back({sentence("Core", "has a colour space that is not known (cICP %1): it is not kept"),
                           extras.unknownColours});
}

/// Returns the picture of all layers in place of the archive that contains it.
InputFile mergedPicture(const std::string& path, PictureSource& source, std::vector<Message>& notices) {
    LayeredFile layered = readLayeredFile(path, source.format);
    notices.insert(notices.end(), layered.notices.begin(), layered.notices.end());
    source.format = PictureFormat::Png;
    source.layers = std::move(layered.layers);
    source.bytes = layered.merged;
    return {path, std::move(layered.merged)};
}

void takePng(const InputFile& file, PictureSource& source, std::vector<Message>& notices) {
    if (std::string problem = pngProblem(file); !problem.empty()) throw InputError(source.path, problem);
    const PngExtras extras = pngExtras(file);
    source.colours = extras.colours;
    source.hasProfile = extras.hasProfile;
    tellOf(extras, notices);
}

void requireDrawable(const InputFile& file) {
    constexpr std::uint64_t kLongest = 256U << 20U;
    if (file.size() > kLongest) throw InputError(file.path(), "is a drawing of more than 256 MB");
}

/// Draws a drawing or one layer of it as pixels.
PictureSource drawing(const InputFile& file, const std::string& layer, const DrawnSize& size,
                      PictureSource source) try {
    requireDrawable(file);
    DrawnSvg drawn = svgLibrary().draw(file.bytes(), layer, size);
    if (layer.empty()) source.layers = std::move(drawn.layers);
    source.bytes = std::move(drawn.picture);
    source.format = PictureFormat::Png;
    return source;
} catch (const InputError& error) {
    throw error.named(source.path);
}

void takeTiff(const InputFile& file, PictureSource& source) {
    PlainTiff plain = plainTiff(file);
    source.isInverted = plain.isInverted(source.page.value_or(0));
    source.bytes = std::move(plain.bytes);
    source.namesExtraSamples = TiffDirectory(file).namesExtraSamples();
}

PictureSource tiffPage(const InputFile& file, const std::string& layer, PictureSource source) try {
    const TiffLayers found = tiffLayers(file);
    source.page = found.pages[layerNamed(found.layers, layer)];
    takeTiff(file, source);
    return source;
} catch (const InputError& error) {
    throw error.named(source.path);
}

}  // namespace

PictureSource sourceOf(const std::string& path, const DrawnSize& size, std::vector<Message>& notices) {
    const InputFile file(path);
    PictureSource source{path, pictureFormat(file)};
    if (source.format == PictureFormat::OpenRaster || source.format == PictureFormat::Krita) {
        takePng(mergedPicture(path, source, notices), source, notices);
        return source;
    }
    if (source.format == PictureFormat::Svg) return drawing(file, {}, size, source);
    if (source.format == PictureFormat::Psd) {
        LayeredFile layered = readPsdFile(file);
        source.bytes = std::move(layered.merged);
        source.layers = std::move(layered.layers);
        return source;
    }
    if (const std::string problem = problemOf(file, source.format); !problem.empty())
        throw InputError(path, problem);
    source.bytes = bytesWithSoundMetadata(file, source.format);
    if (source.format == PictureFormat::Png) takePng(file, source, notices);
    if (source.format == PictureFormat::Tiff) {
        if (TiffDirectory(file).isCameraRaw()) {
            source.format = PictureFormat::Raw;
        } else {
            takeTiff(file, source);
            source.layers = tiffLayers(file).layers;
        }
    }
    return source;
}

PictureSource layerSourceOf(const std::string& path, const std::string& layer, const DrawnSize& size,
                            std::vector<Message>& notices) {
    const InputFile file(path);
    PictureSource source{path, pictureFormat(file)};
    if (source.format == PictureFormat::Tiff) return tiffPage(file, layer, source);
    if (source.format == PictureFormat::Svg) return drawing(file, layer, size, source);
    if (source.format == PictureFormat::Psd)
        source.bytes = readPsdLayer(file, layer);
    else if (source.format == PictureFormat::OpenRaster || source.format == PictureFormat::Krita)
        source.bytes = readLayerPicture(path, source.format, layer);
    else
        throw InputError(path, "has no layers that can be read one by one");
    source.format = PictureFormat::Png;
    takePng({path, source.bytes}, source, notices);
    return source;
}

VectorDrawing vectorSourceOf(const std::string& path, const std::string& layer, const DrawnSize& size) try {
    const InputFile file(path);
    if (pictureFormat(file) != PictureFormat::Svg) throw InputError("is no SVG drawing");
    requireDrawable(file);
    return svgLibrary().vectors(file.bytes(), layer, size);
} catch (const InputError& error) {
    throw error.named(path);
}

}  // namespace wend
