#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "core/mesh/file_access.h"
#include "core/mesh/temporary_folder.h"

namespace wend {

/// A file that is being written under another name near its place (the extension is kept) and takes its
/// place whole, or, if it is never committed, leaves no trace. Until then it lies in a folder that is this
/// user's alone: two of one place do not meet, and nobody's link is followed. An existing file keeps its
/// owner, permissions and attributes, a symbolic link its target's place; a read-only file is not replaced.
/// What is no regular file (a terminal, a pipe, /dev/null) is written to only when all is known to be good; a
/// file that is temporary itself is written in its place.
class PendingFile {
  public:
    /// Throws InputError(path, reason) when the folder is missing or not writable, the file is read-only, or
    /// the path is a folder. Many files of one place share their temporary folder, if each is told of one
    /// before it.
    explicit PendingFile(std::string path, Access access = Access::Usual,
                         const PendingFile* neighbour = nullptr);
    ~PendingFile();
    PendingFile(PendingFile&&) noexcept = default;
    PendingFile& operator=(PendingFile&&) = delete;

    const std::string& path() const { return m_path; }
    /// Where the file will be, links followed.
    const std::string& target() const { return m_target; }
    /// Where to write.
    const std::string& temporary() const { return m_temporary; }
    /// Whether it goes into something that is no regular file, which cannot be taken back.
    bool isSpecial() const { return m_special; }
    /// The file that differs by this extension alone, in its temporary name as well: TetGen's come in pairs.
    PendingFile companion(const std::string& extension) const;
    /// Throws InputError(path, reason).
    void commit();
    /// The same for several: all are on the disk before the first takes its place.
    static void commit(std::span<PendingFile> files);

  private:
    PendingFile() = default;
    void makeTemporary(const PendingFile* neighbour);
    void settle() const;
    void take();

    std::string m_path, m_target, m_temporary;
    Access m_access = Access::Usual;
    bool m_special = false;
    std::shared_ptr<TemporaryFolder> m_folder;  // none if the file is temporary itself
};

/// Calls `write` with the name of a temporary file and puts it in the place of `path` when that returned: an
/// existing file is replaced whole or not at all. The temporary keeps the extension. Throws InputError(path,
/// reason) when the folder is missing, not writable or full, and passes on what `write` throws, the temporary
/// removed.
void writeWhole(const std::string& path, const std::function<void(const std::string& temporary)>& write);
/// The same with what is to stand in the file.
void writeWhole(const std::string& path, std::string_view bytes, Access access = Access::Usual);

}  // namespace wend
