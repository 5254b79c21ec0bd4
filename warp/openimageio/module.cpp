// The interface of the module.

#include <OpenImageIO/imageio.h>

#include <cstdlib>
#include <optional>
#include <string>

#include "warp/openimageio/reader.h"
#include "warp/openimageio/webp_film.h"
#include "warp/openimageio/writer.h"

namespace wend {
namespace {

/// Unsets an environment variable for its lifetime.
class Unset {
  public:
    explicit Unset(const char* name) : m_name(name) {
        const char* value = std::getenv(name);
        if (!value) return;
        m_value = value;
        unsetenv(name);
    }
    ~Unset() {
        if (m_value) setenv(m_name, m_value->c_str(), 1);
    }
    Unset(const Unset&) = delete;
    Unset& operator=(const Unset&) = delete;

  private:
    const char* m_name;
    std::optional<std::string> m_value;
};

class OpenImageIO final : public PictureLibrary {
  public:
    /// Makes OpenImageIO search for plug-ins now, without any path.
    OpenImageIO() {
        const Unset own("OIIO_LIBRARY_PATH"), all("LD_LIBRARY_PATH");
        OIIO::attribute("plugin_searchpath", "");
        OIIO::is_imageio_format_name("png");
    }
    StoredPicture readHeader(const PictureSource& source) const override { return readStoredHeader(source); }
    StoredPicture read(const PictureSource& source, double maxMegapixels, PixelSink& sink) const override {
        return readStored(source, maxMegapixels, sink);
    }
    void write(const PictureToWrite& writing) const override { writeStored(writing); }
    std::unique_ptr<FilmEncoder> film(const FilmToWrite& writing) const override {
        return makeWebpFilm(writing);
    }
};

}  // namespace
}  // namespace wend

extern "C" __attribute__((visibility("default"))) const wend::PictureLibrary* wendPictureLibrary() {
    static const wend::OpenImageIO library;
    return &library;
}
