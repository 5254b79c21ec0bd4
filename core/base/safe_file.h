#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "core/base/error.h"
#include "core/base/file_access.h"
#include "core/base/temporary_folder.h"

namespace wend {

/// An output that the disk has no room for. what() says how much is free.
class DiskFull : public InputError {
  public:
    DiskFull(const std::string& file, double free);
};

/// A file that is written under a temporary name near its target (with its extension) and replaces it as a
/// whole, or leaves no trace if it is never committed. The temporary folder is private: concurrent writers do
/// not collide, and no foreign link is followed. An existing file keeps its owner, permissions and
/// attributes, and a symbolic link is followed; a read-only file is not replaced. Special files (a terminal,
/// a pipe, /dev/null) are written only when all content is valid; a file that is temporary itself is written
/// directly.
class PendingFile {
  public:
    /// Throws InputError(path, reason) if the folder is missing or not writable, the file is read-only, or
    /// the path is a folder. Files in one place share the temporary folder of `neighbour` if it is given.
    explicit PendingFile(std::string path, Access access = Access::Usual,
                         const PendingFile* neighbour = nullptr);
    ~PendingFile();
    PendingFile(PendingFile&&) noexcept = default;
    PendingFile& operator=(PendingFile&&) = delete;

    const std::string& path() const { return m_path; }
    /// Returns the final path, with links followed.
    const std::string& target() const { return m_target; }
    /// Returns the path to write to.
    const std::string& temporary() const { return m_temporary; }
    /// Calls `write` with temporary(). Throws DiskFull in place of its InputError if that is the cause.
    void fill(const std::function<void(const std::string& temporary)>& write) const;
    /// Returns whether the target is a special file, which cannot be rolled back.
    bool isSpecial() const { return m_special; }
    /// Returns a file that differs by this extension alone, in its temporary name as well: TetGen's files
    /// come in pairs.
    PendingFile companion(const std::string& extension) const;
    /// Lets the file replace its target. Throws InputError(path, reason).
    void commit();
    /// Does the same for a file that continues to grow at its target: a process may end at once afterwards
    /// (see abandonPendingFiles()).
    void place();
    /// Does the same for several files: all are on the disk before the first one replaces its target. A
    /// failure before the first replacement leaves all targets as they were; one between two replacements
    /// leaves those before it replaced.
    static void commit(std::span<PendingFile> files);

  private:
    PendingFile() = default;
    void makeTemporary(const PendingFile* neighbour);
    [[noreturn]] void fail(int error) const;
    [[noreturn]] void fail(const InputError& error) const;
    void settle() const;
    void take();

    std::string m_path, m_target, m_temporary;
    Access m_access = Access::Usual;
    bool m_special = false;
    std::shared_ptr<TemporaryFolder> m_folder;  // none if the file is temporary itself
};

/// Throws the error of writing into `folder`, or DiskFull if that is its cause. `given` is how many bytes
/// will be free once the written data is removed.
[[noreturn]] void throwExplained(const InputError& error, const std::string& folder, double given = 0);

/// Prepares the end of a process that does not destroy its objects: from now on no file replaces its target,
/// and the temporary ones are removed. Returns false, with nothing changed, once a file has replaced its
/// target: then the work is as good as done.
bool abandonPendingFiles() noexcept;

/// Calls `write` with a temporary name, and moves the file to `path` afterwards: an existing file is replaced
/// as a whole or not at all. The temporary name keeps the extension. Throws InputError(path, reason) if the
/// folder is missing, not writable or full, and rethrows exceptions of `write` after removing the temporary.
void writeWhole(const std::string& path, const std::function<void(const std::string& temporary)>& write);
/// Writes these bytes in the same manner.
void writeWhole(const std::string& path, std::string_view bytes, Access access = Access::Usual);

}  // namespace wend
