#pragma once

#include <string>

namespace wend {

/// A new hidden private folder that is removed with its contents. A lock shows that its program is alive:
/// folders of killed programs are removed by the next one that works in the same place.
class TemporaryFolder {
  public:
    /// Creates it in `parent`. Throws InputError(parent, reason).
    explicit TemporaryFolder(std::string parent);
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    const std::string& parent() const { return m_parent; }
    const std::string& path() const { return m_path; }
    /// Returns a new short name in the folder, however long the name of the target is.
    std::string newName(const std::string& extension);

  private:
    bool tryToMake();

    std::string m_parent, m_path;
    int m_lock = -1;
    int m_count = 0;
};

/// Removes the folders of this process with all that is in them, for a process that ends without destroying
/// what it has made.
void removeTemporaryFolders() noexcept;

/// Returns whether a file is in such a folder.
bool isTemporary(const std::string& file);

/// Returns a folder for temporary files without a target. Throws InputError.
std::string scratchFolder();

}  // namespace wend
