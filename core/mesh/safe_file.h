#pragma once

#include <functional>
#include <string>

namespace wend {

/// A new folder, open to this user alone, that goes with all that is in it.
class TemporaryFolder {
  public:
    /// In `parent`. Throws std::filesystem::filesystem_error.
    explicit TemporaryFolder(const std::string& parent);
    ~TemporaryFolder();
    TemporaryFolder(TemporaryFolder&& other) noexcept;
    TemporaryFolder& operator=(TemporaryFolder&&) = delete;

    const std::string& path() const { return m_path; }

  private:
    std::string m_path;
};

/// A file that is being written in a temporary folder beside its place, under its own name, and takes its
/// place whole, or, if it is never committed, leaves no trace. What is written beside it there (the other of
/// TetGen's two files) goes along. An existing file keeps its permissions, a symbolic link its target's
/// place. What is no regular file (a terminal, a pipe, /dev/null) is written to only when all is known to be
/// good.
class PendingFile {
  public:
    /// Throws InputError(path, reason) when the folder is missing or not writable, or the path is a folder.
    explicit PendingFile(std::string path);

    const std::string& path() const { return m_path; }
    /// Where the file will be, links followed.
    const std::string& target() const { return m_target; }
    /// Where to write.
    const std::string& temporary() const { return m_temporary; }
    /// Whether it goes into something that is no regular file, which cannot be taken back.
    bool isSpecial() const { return m_special; }
    /// Throws InputError(path, reason).
    void commit();

  private:
    std::string m_path, m_target;
    bool m_special;
    TemporaryFolder m_folder;
    std::string m_temporary;
};

/// Calls `write` with the name of a temporary file in the folder of `path` and renames it to `path` when that
/// returned: an existing file is replaced whole or not at all. The temporary keeps the extension. Throws
/// InputError(path, reason) when the folder is missing, not writable or full, and passes on what `write`
/// throws, the temporary removed.
void writeWhole(const std::string& path, const std::function<void(const std::string& temporary)>& write);

}  // namespace wend
