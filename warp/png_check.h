#pragma once

#include <string>

namespace wend {

/// Walks the chunks of a PNG without decoding. Returns what is wrong (truncated, a chunk that no file of this
/// size can hold, more pixels than can come out of so little data), empty if nothing. Files that are no PNG
/// pass. Why: libpng prints its own messages, and allocation goes by what a 74-byte file may
/// claim.
std::string pngProblem(const std::string& path);

}  // namespace wend
