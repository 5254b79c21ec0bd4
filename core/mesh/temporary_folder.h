#pragma once

#include <string>

namespace wend {

/// A new hidden folder, open to this user alone, that goes with all that is in it. A lock tells others that
/// its program lives: what a killed one left is taken away by the next that works in the same place.
class TemporaryFolder {
  public:
    /// In `parent`. Throws InputError(parent, reason).
    explicit TemporaryFolder(std::string parent);
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    const std::string& parent() const { return m_parent; }
    const std::string& path() const { return m_path; }
    /// A name in it that was not given yet: short, however long the name of the file that it stands for.
    std::string newName(const std::string& extension);

  private:
    bool tryToMake();

    std::string m_parent, m_path;
    int m_lock = -1;
    int m_count = 0;
};

/// Whether a file lies in such a folder: it goes with it, or is moved from there to where it belongs.
bool isTemporary(const std::string& file);

/// For what has no folder of its own. Throws InputError.
std::string scratchFolder();

}  // namespace wend
