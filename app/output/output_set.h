#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/base/safe_file.h"

namespace wend {

/// The files that a run leaves, all of them whole or none: they are written under other names, and take their
/// places together at the end. "-" is standard output, which gets its bytes then, too.
class OutputSet {
  public:
    using Write = std::function<void(const std::string& temporary)>;

    /// Calls `write` with the file to write, which has the extension of `path`, or that given for "-". Errors
    /// name `path`.
    void add(const std::string& path, const std::string& extension, const Write& write);
    /// Adds a file that is written bit by bit until commit(). Returns the name to write to, which has the
    /// extension of `path`. Throws InputError.
    std::string begin(const std::string& path);
    /// Calls `write`, which writes to a file that begin() has added. Errors name `path`.
    void extend(const std::string& path, const std::function<void()>& write);
    /// Puts everything in its place. Throws InputError.
    void commit();
    /// Forgets what was added: none of it will be there.
    void discard();

  private:
    std::vector<PendingFile> m_files;
    std::optional<std::string> m_standardOutput;  // its bytes
};

/// Returns the file and the files that are written with it: TetGen's come in pairs.
std::vector<std::string> writtenAlong(const std::string& path);

/// Throws InputError if a file cannot be written there, so that this is known before the work begins. "-" is
/// always possible; empty names are ignored.
void requirePlaces(const std::vector<std::string>& paths);

/// Returns "dir/f_0007.png" for "dir/f_####.png" and 7: the last run of # is the number.
std::string frameName(const std::string& pattern, int number);
/// Returns the number of the frame that has this name in the sequence, if there is one.
std::optional<int> frameNumber(const std::string& pattern, const std::string& name);

}  // namespace wend
