#pragma once

#include <functional>
#include <optional>
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

/// A file that is being written under another name beside its place (the extension is kept) and takes its
/// place whole, or, if it is never committed, leaves no trace. The name is new: two of one place do not meet,
/// and nobody's link is followed. An existing file keeps its permissions, a symbolic link its target's place.
/// What is no regular file (a terminal, a pipe, /dev/null) is written to only when all is known to be good.
class PendingFile {
  public:
    /// Throws InputError(path, reason) when the folder is missing or not writable, or the path is a folder.
    explicit PendingFile(std::string path);
    ~PendingFile();
    PendingFile(PendingFile&& other) noexcept;
    PendingFile& operator=(PendingFile&&) = delete;

    const std::string& path() const { return m_path; }
    /// Where the file will be, links followed.
    const std::string& target() const { return m_target; }
    /// Where to write.
    const std::string& temporary() const { return m_temporary; }
    /// Whether it goes into something that is no regular file, which cannot be taken back.
    bool isSpecial() const { return m_folder.has_value(); }
    /// The file that differs by this extension alone, in its temporary name as well: TetGen's come in pairs.
    PendingFile companion(const std::string& extension) const;
    /// Throws InputError(path, reason).
    void commit();

  private:
    PendingFile(std::string path, std::string target, std::string temporary);

    std::string m_path, m_target, m_temporary;
    std::optional<TemporaryFolder> m_folder;  // of what has no place beside it
};

/// Calls `write` with the name of a temporary file in the folder of `path` and renames it to `path` when that
/// returned: an existing file is replaced whole or not at all. The temporary keeps the extension. Throws
/// InputError(path, reason) when the folder is missing, not writable or full, and passes on what `write`
/// throws, the temporary removed.
void writeWhole(const std::string& path, const std::function<void(const std::string& temporary)>& write);

}  // namespace wend
