#pragma once

#include "warp/picture_library.h"

namespace wend {

/// As PictureLibrary::film says.
std::unique_ptr<FilmEncoder> makeWebpFilm(const FilmToWrite& writing);

}  // namespace wend
