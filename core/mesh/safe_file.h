#pragma once

#include <functional>
#include <string>

namespace wend {

/// A file that is being written under another name beside its place (the extension is kept) and takes its
/// place whole, or, if it is never committed, leaves no trace. An existing file keeps its permissions, a
/// symbolic link its target's place. What is no regular file (a terminal, a pipe, /dev/null) is written to
/// only when all is known to be good.
class PendingFile {
  public:
    /// Throws InputError(path, reason) when the folder is missing or not writable, or the path is a folder.
    explicit PendingFile(std::string path);
    ~PendingFile();
    PendingFile(PendingFile&& other) noexcept;
    PendingFile& operator=(PendingFile&&) = delete;

    const std::string& path() const { return m_path; }
    /// Where to write.
    const std::string& temporary() const { return m_temporary; }
    /// Throws InputError(path, reason).
    void commit();

  private:
    std::string m_path, m_target, m_temporary;
};

/// Calls `write` with the name of a temporary file in the folder of `path` and renames it to `path` when that
/// returned: an existing file is replaced whole or not at all. The temporary keeps the extension. Throws
/// InputError(path, reason) when the folder is missing, not writable or full, and passes on what `write`
/// throws, the temporary removed.
void writeWhole(const std::string& path, const std::function<void(const std::string& temporary)>& write);

}  // namespace wend
