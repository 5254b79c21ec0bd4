#include "warp/film.h"

#include "core/base/error.h"
#include "warp/convert.h"
#include "warp/ffmpeg_film.h"
#include "warp/film_format.h"
#include "warp/picture_library.h"
#include "warp/warped_picture.h"

namespace wend {
namespace {

std::unique_ptr<FilmEncoder> encoderFor(const FilmToWrite& writing) {
    requireFilmFormat(writing.path);
    const FilmFormatFacts& format = *filmFormatOf(writing.path);
    if (format.id == FilmFormat::Webp) return pictureLibrary(writing.path).film(writing);
    return makeFfmpegFilm(writing, format);
}

}  // namespace

Film::Film(const std::string& path, const std::string& file, const FilmOptions& options)
    : m_encoder(encoderFor({path, file, options})), m_alpha(filmFormatOf(path)->alpha) {}

Film::~Film() = default;

void Film::add(const WarpedPicture& picture) {
    Image frame = picture.header();
    frame.makePixels();
    if (!picture.paint(0, frame)) throw Cancelled();
    add(frame);
}

void Film::add(const Image& frame) {
    m_encoder->add(converted(frame, {PixelType::UInt8, m_alpha ? 4 : 3, m_alpha, m_alpha}));
}

void Film::finish() {
    m_encoder->finish();
}

}  // namespace wend
