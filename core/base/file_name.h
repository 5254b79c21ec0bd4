#pragma once

#include <string>

namespace wend {

/// Returns the extension in lower case, ".png" of "folder/A.PNG"; empty if there is none. The points of an
/// OpenFOAM mesh, which are in a file "points", count as ".foam".
std::string lowerExtension(const std::string& path);

}  // namespace wend
