#pragma once

#include <string>
#include <vector>

#include "warp/picture_library.h"

namespace wend {

/// Returns what a picture's file is by its content, not by its name, with the facts that its format's library
/// does not report. `notices` receives what the user should know. Throws InputError.
PictureSource sourceOf(const std::string& path, std::vector<std::string>& notices);

/// Does the same for one layer of a file with layers.
PictureSource layerSourceOf(const std::string& path, const std::string& layer,
                            std::vector<std::string>& notices);

}  // namespace wend
