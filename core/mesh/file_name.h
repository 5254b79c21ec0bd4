#pragma once

#include <string>

namespace wend {

/// Returns the extension in lower case, ".png" of "folder/A.PNG"; empty if there is none.
std::string lowerExtension(const std::string& path);

}  // namespace wend
