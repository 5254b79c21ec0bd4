#pragma once

#include <string>
#include <vector>

namespace wend {

/// Whether two names mean one file: through links, hard links and relative spellings, and also where there is
/// no such file yet. Empty names and "-" are no files.
bool sameFile(const std::string& a, const std::string& b);

/// The first of `files` that is the same as `file`; empty if none is.
std::string sameAmong(const std::vector<std::string>& files, const std::string& file);

/// The name without links and detours; what cannot be followed stays as it is.
std::string canonicalName(const std::string& path);

}  // namespace wend
