#pragma once

#include <string>

namespace wend {

/// ".png" of "folder/A.PNG"; empty without one.
std::string lowerExtension(const std::string& path);

}  // namespace wend
