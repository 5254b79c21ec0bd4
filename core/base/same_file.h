#pragma once

#include <string>

namespace wend {

/// Returns whether two names refer to one file: through links, hard links and relative paths, even if it does
/// not exist yet. Empty names and "-" are no files.
bool sameFile(const std::string& a, const std::string& b);

/// Returns the name without links and redundant parts, as far as it can be resolved.
std::string canonicalName(const std::string& path);

}  // namespace wend
