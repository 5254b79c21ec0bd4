#pragma once

#include <string>

namespace wend {

/// Whether two names mean one file: through links, hard links and relative spellings, and also where there is
/// no such file yet. Empty names and "-" are no files.
bool sameFile(const std::string& a, const std::string& b);

/// The name without links and detours; what cannot be followed stays as it is.
std::string canonicalName(const std::string& path);

}  // namespace wend
