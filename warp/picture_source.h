#pragma once

#include <string>
#include <vector>

#include "warp/picture_library.h"

namespace wend {

/// Returns what a picture's file is by what is in it, not by its name, with what its format's library does
/// not tell. `notices` receives what the user should know. Throws InputError.
PictureSource sourceOf(const std::string& path, std::vector<std::string>& notices);

/// The same for one layer of a file with layers.
PictureSource layerSourceOf(const std::string& path, const std::string& layer,
                            std::vector<std::string>& notices);

}  // namespace wend
