#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/mesh/safe_file.h"

namespace wend {

/// The files that a run leaves, all of them whole or none: they are written under other names, and take their
/// places together at the end. "-" is standard output, which gets its bytes then, too.
class OutputSet {
  public:
    using Write = std::function<void(const std::string& temporary)>;

    /// Calls `write` with the file to write, which has the extension of `path`, or that given for "-". Errors
    /// name `path`.
    void add(const std::string& path, const std::string& extension, const Write& write);
    /// Puts everything in its place. Throws InputError.
    void commit();

  private:
    std::vector<PendingFile> m_files;
    std::optional<std::string> m_standardOutput;  // its bytes
};

/// Throws InputError if a file cannot be put there: to be told before the work begins. "-" always can.
void requirePlace(const std::string& path);

std::string lowerExtension(const std::string& path);

}  // namespace wend
