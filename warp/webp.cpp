#include "warp/webp.h"

#include <webp/decode.h>
#include <webp/encode.h>
#include <webp/mux.h>

#include <fstream>
#include <iterator>
#include <memory>

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

/// The lossless stream of the pixels, colours under transparent ones included; empty with the reason in
/// `error`.
Bytes encoded(const Image& image, std::string& error) {
    WebPConfig config;
    WebPPicture picture;
    WebPMemoryWriter writer;
    if (!WebPConfigInit(&config) || !WebPConfigLosslessPreset(&config, 3) || !WebPPictureInit(&picture)) {
        error = "the WebP library is of another version";
        return {};
    }
    config.exact = 1;
    WebPMemoryWriterInit(&writer);
    const std::unique_ptr<WebPPicture, void (*)(WebPPicture*)> pictureGuard(&picture, WebPPictureFree);
    const std::unique_ptr<WebPMemoryWriter, void (*)(WebPMemoryWriter*)> writerGuard(&writer,
                                                                                     WebPMemoryWriterClear);
    picture.use_argb = 1;
    picture.width = image.width, picture.height = image.height;
    picture.writer = WebPMemoryWrite, picture.custom_ptr = &writer;
    const auto* pixels = reinterpret_cast<const std::uint8_t*>(image.data.data());
    const auto import = image.channels == 4 ? WebPPictureImportRGBA : WebPPictureImportRGB;
    if (!import(&picture, pixels, image.channels * image.width) || !WebPEncode(&config, &picture)) {
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

/// The file: the stream and its profile.
Bytes assembled(const Bytes& stream, const OIIO::ImageSpec& spec) {
    const Bytes profile = profileOf(spec);
    if (profile.empty()) return stream;
    const Mux mux(WebPMuxNew(), WebPMuxDelete);
    const WebPData image = asData(stream), icc = asData(profile);
    WebPData file{};
    const bool good = WebPMuxSetImage(mux.get(), &image, 0) == WEBP_MUX_OK &&
                      WebPMuxSetChunk(mux.get(), "ICCP", &icc, 0) == WEBP_MUX_OK &&
                      WebPMuxAssemble(mux.get(), &file) == WEBP_MUX_OK;
    if (!good) return stream;
    const Bytes bytes(file.bytes, file.bytes + file.size);
    WebPDataClear(&file);
    return bytes;
}

}  // namespace

std::string writeWebp(const std::string& path, const Image& image, const OIIO::ImageSpec& spec) {
    if (image.width > WEBP_MAX_DIMENSION || image.height > WEBP_MAX_DIMENSION)
        return "WebP holds at most " + std::to_string(WEBP_MAX_DIMENSION) + " pixels a side";
    std::string error;
    const Bytes stream = encoded(image, error);
    if (stream.empty()) return error;
    const Bytes bytes = assembled(stream, spec);
    std::ofstream file(path, std::ios::binary);
    file.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    file.close();
    return file ? "" : "the disk may be full";
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

void readWebpProfile(const std::string& path, OIIO::ImageSpec& spec) {
    const Bytes bytes = contents(path);
    const WebPData data = asData(bytes);
    const Mux mux(WebPMuxCreate(&data, 0), WebPMuxDelete);
    WebPData profile{};
    if (!mux || WebPMuxGetChunk(mux.get(), "ICCP", &profile) != WEBP_MUX_OK) return;
    spec.attribute("ICCProfile", OIIO::TypeDesc(OIIO::TypeDesc::UINT8, static_cast<int>(profile.size)),
                   profile.bytes);
}

}  // namespace wend
