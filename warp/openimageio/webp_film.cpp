#include "warp/openimageio/webp_film.h"

#include <webp/mux.h>

#include <cmath>
#include <limits>

#include "core/base/checked_file.h"
#include "core/base/error.h"
#include "warp/openimageio/webp.h"
#include "warp/openimageio/writer.h"

namespace wend {
namespace {

constexpr double kLongest = 16777.215;  // seconds that a frame may last: 24 bits of milliseconds

class WebpFilm final : public FilmEncoder {
  public:
    explicit WebpFilm(FilmToWrite writing) : m_writing(std::move(writing)) {
        const double rate = m_writing.options.framesPerSecond;
        if (rate > 1000 || 1 / rate > kLongest) fail("a WebP film has from 0.0001 to 1000 frames per second");
        if (!prepareWebp(m_config, m_writing.options.lossy)) fail("the WebP library is of another version");
    }

    void add(const Image& frame) override {
        if (!m_encoder) begin(frame);
        WebPPicture picture;
        const bool imported = importWebp(picture, frame);
        const std::unique_ptr<WebPPicture, void (*)(WebPPicture*)> guard(&picture, WebPPictureFree);
        if (!imported || !WebPAnimEncoderAdd(m_encoder.get(), &picture, timeOf(m_count), &m_config)) fail();
        ++m_count;
    }

    void finish() override {
        WebPData file{};
        if (!WebPAnimEncoderAdd(m_encoder.get(), nullptr, timeOf(m_count), nullptr) ||
            !WebPAnimEncoderAssemble(m_encoder.get(), &file))
            fail();
        std::vector<std::uint8_t> bytes(file.bytes, file.bytes + file.size);
        WebPDataClear(&file);
        bytes = withMetadata(std::move(bytes), m_spec);
        const std::string error =
            writeBytes(m_writing.file, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
        if (!error.empty()) fail(error);
    }

  private:
    void begin(const Image& frame) {
        if (frame.width > WEBP_MAX_DIMENSION || frame.height > WEBP_MAX_DIMENSION)
            fail("WebP holds at most " + std::to_string(WEBP_MAX_DIMENSION) + " pixels a side");
        m_spec = fileSpec(PictureFormat::Webp, frame);
        WebPAnimEncoderOptions options;
        if (!WebPAnimEncoderOptionsInit(&options)) fail("the WebP library is of another version");
        options.anim_params.bgcolor = 0;  // nothing
        m_encoder.reset(WebPAnimEncoderNew(frame.width, frame.height, &options));
        if (!m_encoder) fail("there is not enough memory");
    }

    /// Returns the start of a frame in whole milliseconds, without accumulated rounding.
    int timeOf(int frame) const {
        const double time = std::round(1000 * frame / m_writing.options.framesPerSecond);
        if (time > std::numeric_limits<int>::max()) fail("a WebP film lasts 24 days at most");
        return static_cast<int>(time);
    }

    [[noreturn]] void fail(const std::string& why) const {
        throw InputError(m_writing.path, "cannot be written: " + why);
    }
    [[noreturn]] void fail() const {
        fail("the WebP encoder failed (" + std::string(WebPAnimEncoderGetError(m_encoder.get())) + ")");
    }

    FilmToWrite m_writing;
    WebPConfig m_config;
    OIIO::ImageSpec m_spec;
    std::unique_ptr<WebPAnimEncoder, void (*)(WebPAnimEncoder*)> m_encoder{nullptr, WebPAnimEncoderDelete};
    int m_count = 0;
};

}  // namespace

std::unique_ptr<FilmEncoder> makeWebpFilm(const FilmToWrite& writing) {
    return std::make_unique<WebpFilm>(writing);
}

}  // namespace wend
