#pragma once

#include <string>
#include <vector>

namespace wend {

/// Gives the pages of a TIFF file, which this machine has written, their names (PageName), in UTF-8: a
/// directory for each is added at its end, since OpenImageIO writes no such entry. Throws InputError.
void nameTiffPages(const std::string& path, const std::vector<std::string>& names);

}  // namespace wend
