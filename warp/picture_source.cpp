#include "warp/picture_source.h"

#include <cstddef>
#include <cstdint>
#include <optional>

#include "core/mesh/error.h"
#include "warp/bmp_check.h"
#include "warp/byte_numbers.h"
#include "warp/layered_file.h"
#include "warp/metadata_check.h"
#include "warp/picture_format.h"
#include "warp/png_check.h"
#include "warp/png_colours.h"
#include "warp/psd_file.h"
#include "warp/tga_check.h"

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

void tellOf(const PngExtras& extras, std::vector<std::string>& notices) {
    if (extras.frames > 1) notices.push_back(severalPictures(extras.frames));
    if (!extras.unknownColours.empty())
        notices.push_back("has a colour space that is not known (cICP " + extras.unknownColours +
                          "): it is not kept");
}

/// The first directory of a TIFF. Of a BigTIFF, and of one that is cut off, nothing is known.
class TiffDirectory {
  public:
    explicit TiffDirectory(const InputFile& file) : m_head(file.bytes(0, 16)) {
        constexpr std::uint32_t kClassic = 42;
        if (m_head.size() < 8) return;
        const std::uint64_t directory = number(m_head, 4, 4);
        const std::string count = file.bytes(directory, 2);
        if (number(m_head, 2, 2) != kClassic || count.size() < 2) return;
        m_entries = file.bytes(directory + 2, kEntry * number(count, 0, 2));
    }
    bool isKnown() const { return !m_entries.empty(); }

    /// Returns the number of an entry; nothing without that entry.
    std::optional<std::uint32_t> value(std::uint32_t tag) const {
        constexpr std::uint32_t kShort = 3;
        for (std::size_t at = 0; at + kEntry <= m_entries.size(); at += kEntry)
            if (number(m_entries, at, 2) == tag)
                return number(m_entries, at + 8, number(m_entries, at + 2, 2) == kShort ? 2 : 4);
        return std::nullopt;
    }

    /// Returns whether the file contains the data of a camera's sensor, by DNG's version, Canon's mark, the
    /// photometric interpretation, or a small picture of a camera before the large one.
    bool isCameraRaw() const {
        constexpr std::uint32_t kSubfile = 254, kPhotometric = 262, kMake = 271, kParts = 330, kDng = 50706;
        constexpr std::uint32_t kSensor = 32803;
        const bool isSmall = (value(kSubfile).value_or(0) & 1U) != 0;
        return value(kDng) || value(kPhotometric) == kSensor || m_head.substr(8, 2) == "CR" ||
               (isSmall && value(kMake) && value(kParts));
    }
    /// Returns whether it says what the samples after the colours are.
    bool namesExtraSamples() const {
        constexpr std::uint32_t kExtraSamples = 338;
        return !isKnown() || value(kExtraSamples);
    }

  private:
    static constexpr std::size_t kEntry = 12;

    std::uint32_t number(const std::string& bytes, std::size_t at, std::size_t size) const {
        return m_head[0] == 'I' ? littleEndian(bytes, at, size) : bigEndian(bytes, at, size);
    }

    std::string m_head, m_entries;
};

/// The picture of all layers, in place of the archive that it is in.
InputFile mergedPicture(const std::string& path, PictureSource& source) {
    LayeredFile layered = readLayeredFile(path, source.format);
    source.format = PictureFormat::Png;
    source.layers = std::move(layered.layers);
    source.bytes = layered.merged;
    return {path, std::move(layered.merged)};
}

void takePng(const InputFile& file, PictureSource& source, std::vector<std::string>& notices) {
    if (std::string problem = pngProblem(file); !problem.empty()) throw InputError(source.path, problem);
    const PngExtras extras = pngExtras(file);
    source.colours = extras.colours;
    tellOf(extras, notices);
}

}  // namespace

PictureSource sourceOf(const std::string& path, std::vector<std::string>& notices) {
    const InputFile file(path);
    PictureSource source{path, pictureFormat(file)};
    if (source.format == PictureFormat::OpenRaster || source.format == PictureFormat::Krita) {
        takePng(mergedPicture(path, source), source, notices);
        return source;
    }
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
        const TiffDirectory directory(file);
        source.namesExtraSamples = directory.namesExtraSamples();
        if (directory.isCameraRaw()) source.format = PictureFormat::Raw;
    }
    return source;
}

PictureSource layerSourceOf(const std::string& path, const std::string& layer,
                            std::vector<std::string>& notices) {
    const InputFile file(path);
    PictureSource source{path, pictureFormat(file)};
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

}  // namespace wend
