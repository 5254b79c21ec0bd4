#pragma once

#include "warp/picture_library.h"

namespace wend {

/// See PictureLibrary::film.
std::unique_ptr<FilmEncoder> makeWebpFilm(const FilmToWrite& writing);

}  // namespace wend
