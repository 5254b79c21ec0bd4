#include "warp/openimageio/webp.h"

#include <webp/decode.h>
#include <webp/mux.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <memory>
#include <string_view>
#include <utility>

#include "core/base/checked_file.h"
#include "warp/exif_check.h"

// As in OpenImageIO/tiffutils.h, whose other declarations need libtiff's headers.
OIIO_NAMESPACE_BEGIN
// NOLINTBEGIN(readability-identifier-naming)
OIIO_API void encode_exif(const ImageSpec& spec, std::vector<char>& blob, OIIO::endian order);
OIIO_API bool decode_exif(string_view exif, ImageSpec& spec);
OIIO_API std::string encode_xmp(const ImageSpec& spec, bool minimal);
OIIO_API bool decode_xmp(string_view xml, ImageSpec& spec);
// NOLINTEND(readability-identifier-naming)
OIIO_NAMESPACE_END

namespace wend {
namespace {

using Bytes = std::vector<std::uint8_t>;
using Mux = std::unique_ptr<WebPMux, void (*)(WebPMux*)>;

Bytes contents(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

WebPData asData(const Bytes& bytes) {
    return {bytes.data(), bytes.size()};
}

/// Returns the stream of the pixels; without loss, colours under transparent ones are kept, too. Empty with
/// the reason in `error`.
Bytes encoded(const Image& image, bool lossy, std::string& error) {
    WebPConfig config;
    WebPPicture picture;
    WebPMemoryWriter writer;
    if (!prepareWebp(config, lossy)) {
        error = "the WebP library is of another version";
        return {};
    }
    WebPMemoryWriterInit(&writer);
    const bool imported = importWebp(picture, image);
    const std::unique_ptr<WebPPicture, void (*)(WebPPicture*)> pictureGuard(&picture, WebPPictureFree);
    const std::unique_ptr<WebPMemoryWriter, void (*)(WebPMemoryWriter*)> writerGuard(&writer,
                                                                                     WebPMemoryWriterClear);
    picture.writer = WebPMemoryWrite, picture.custom_ptr = &writer;
    if (!imported || !WebPEncode(&config, &picture)) {
        error = "the WebP encoder failed (error " + std::to_string(picture.error_code) + ")";
        return {};
    }
    return {writer.mem, writer.mem + writer.size};
}

Bytes profileOf(const OIIO::ImageSpec& spec) {
    const OIIO::ParamValue* profile = spec.find_attribute("ICCProfile");
    if (!profile) return {};
    const auto* bytes = static_cast<const std::uint8_t*>(profile->data());
    return {bytes, bytes + profile->datasize()};
}

/// Returns date, author, camera and other EXIF entries; empty if there are none.
Bytes exifOf(const OIIO::ImageSpec& spec) {
    if (spec.extra_attribs.size() == 0) return {};
    std::vector<char> blob;
    OIIO::encode_exif(spec, blob, OIIO::endian::little);
    return {blob.begin(), blob.end()};
}

Bytes xmpOf(const OIIO::ImageSpec& spec) {
    const std::string xmp = OIIO::encode_xmp(spec, true);
    return {xmp.begin(), xmp.end()};
}

/// Returns a chunk's bytes, which `mux` owns; empty without one.
std::string_view chunk(const WebPMux* mux, const char* name) {
    WebPData data{};
    if (WebPMuxGetChunk(mux, name, &data) != WEBP_MUX_OK) return {};
    return {reinterpret_cast<const char*>(data.bytes), data.size};
}

}  // namespace

bool prepareWebp(WebPConfig& config, bool lossy) {
    constexpr float kQuality = 90;
    if (!WebPConfigPreset(&config, WEBP_PRESET_DEFAULT, kQuality)) return false;
    config.use_sharp_yuv = 1;  // preserves thin coloured lines
    if (lossy) return true;
    config.exact = 1;
    return WebPConfigLosslessPreset(&config, 3) != 0;
}

bool importWebp(WebPPicture& picture, const Image& image) {
    if (!WebPPictureInit(&picture)) return false;
    picture.use_argb = 1;
    picture.width = image.width, picture.height = image.height;
    const auto* pixels = reinterpret_cast<const std::uint8_t*>(image.data.data());
    const auto import = image.channels == 4 ? WebPPictureImportRGBA : WebPPictureImportRGB;
    return import(&picture, pixels, image.channels * image.width) != 0;
}

Bytes withMetadata(Bytes file, const OIIO::ImageSpec& spec) {
    const std::array<std::pair<const char*, Bytes>, 3> chunks{
        {{"ICCP", profileOf(spec)}, {"EXIF", exifOf(spec)}, {"XMP ", xmpOf(spec)}}};
    const WebPData bare = asData(file);
    const Mux mux(WebPMuxCreate(&bare, 0), WebPMuxDelete);
    bool good = mux != nullptr, any = false;
    for (const auto& [name, bytes] : chunks) {
        if (bytes.empty()) continue;
        const WebPData data = asData(bytes);
        good = good && WebPMuxSetChunk(mux.get(), name, &data, 0) == WEBP_MUX_OK;
        any = true;
    }
    WebPData all{};
    if (!any || !good || WebPMuxAssemble(mux.get(), &all) != WEBP_MUX_OK) return file;
    file.assign(all.bytes, all.bytes + all.size);
    WebPDataClear(&all);
    return file;
}

std::string writeWebp(const std::string& path, const Image& image, const OIIO::ImageSpec& spec, bool lossy) {
    if (image.width > WEBP_MAX_DIMENSION || image.height > WEBP_MAX_DIMENSION)
        return "WebP holds at most " + std::to_string(WEBP_MAX_DIMENSION) + " pixels a side";
    std::string error;
    Bytes stream = encoded(image, lossy, error);
    if (stream.empty()) return error;
    const Bytes bytes = withMetadata(std::move(stream), spec);
    return writeBytes(path, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

bool readWebp(const std::string& path, Image& image) {
    const Bytes bytes = contents(path);
    const auto decode = image.channels == 4 ? WebPDecodeRGBAInto : WebPDecodeRGBInto;
    std::vector<std::byte> pixels(image.rowBytes() * static_cast<std::size_t>(image.height));
    auto* target = reinterpret_cast<std::uint8_t*>(pixels.data());
    if (!decode(bytes.data(), bytes.size(), target, pixels.size(), image.channels * image.width))
        return false;
    image.data = std::move(pixels);
    image.unassociated = image.alpha;
    return true;
}

int webpFrames(const std::string& path) {
    const Bytes bytes = contents(path);
    const WebPData data = asData(bytes);
    const Mux mux(WebPMuxCreate(&data, 0), WebPMuxDelete);
    int count = 0;
    if (!mux || WebPMuxNumChunks(mux.get(), WEBP_CHUNK_ANMF, &count) != WEBP_MUX_OK) return 1;
    return std::max(count, 1);
}

void readWebpMetadata(const std::string& path, OIIO::ImageSpec& spec) {
    const Bytes bytes = contents(path);
    const WebPData data = asData(bytes);
    const Mux mux(WebPMuxCreate(&data, 0), WebPMuxDelete);
    if (!mux) return;
    const std::string_view profile = chunk(mux.get(), "ICCP"), xmp = chunk(mux.get(), "XMP ");
    std::string exif(chunk(mux.get(), "EXIF"));
    if (exif.starts_with(std::string_view("Exif\0\0", 6))) exif.erase(0, 6);  // JPEG's, by some programs
    if (!profile.empty())
        spec.attribute("ICCProfile", OIIO::TypeDesc(OIIO::TypeDesc::UINT8, static_cast<int>(profile.size())),
                       profile.data());
    if (mendExif(exif, 0, exif.size()) != ExifState::Useless)
        OIIO::decode_exif(OIIO::string_view(exif.data(), exif.size()), spec);
    if (!xmp.empty()) OIIO::decode_xmp(OIIO::string_view(xmp.data(), xmp.size()), spec);
}

}  // namespace wend
