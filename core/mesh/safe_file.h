#pragma once

#include <functional>
#include <string>

namespace wend {

/// Calls `write` with the name of a temporary file in the folder of `path` and renames it to `path` when that
/// returned: an existing file is replaced whole or not at all. The temporary keeps the extension. Throws
/// InputError(path, reason) when the folder is missing, not writable or full, and passes on what `write`
/// throws, the temporary removed.
void writeWhole(const std::string& path, const std::function<void(const std::string& temporary)>& write);

}  // namespace wend
