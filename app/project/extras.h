#pragma once

#include <string>
#include <utility>
#include <vector>

namespace wend {

/// Unknown content of a file's objects, kept for the next save: JSON pointers relative to the object, and the
/// values as JSON text.
using Extras = std::vector<std::pair<std::string, std::string>>;

}  // namespace wend
