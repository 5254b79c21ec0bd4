#pragma once

#include "warp/film_format.h"
#include "warp/picture_library.h"

namespace wend {

/// Makes a film by the program ffmpeg, which gets the frames through a pipe. Throws InputError for a rate
/// that the format does not hold and for sound that is not there.
std::unique_ptr<FilmEncoder> makeFfmpegFilm(const FilmToWrite& writing, const FilmFormatFacts& format);

}  // namespace wend
