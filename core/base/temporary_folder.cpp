#include "core/base/temporary_folder.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <mutex>
#include <set>
#include <utility>

#include "core/base/error.h"

namespace wend {
namespace fs = std::filesystem;

namespace {

constexpr const char* kName = ".wend-XXXXXX";
constexpr const char* kLock = "lock";

bool hasOurName(const fs::path& folder) {
    const std::string name = folder.filename().string();
    return name.starts_with(".wend-") && name.size() == std::strlen(kName);
}

bool isOurs(const fs::path& folder) {
    struct stat status {};
    return hasOurName(folder) && lstat(folder.c_str(), &status) == 0 && S_ISDIR(status.st_mode) &&
           status.st_uid == geteuid();
}

/// An empty folder is being created, or was left by a process that ended then: its creator makes another if
/// necessary. If the lock is free, the owner is dead.
void removeIfAbandoned(const fs::path& folder) {
    const int lock = open((folder / kLock).c_str(), O_RDWR | O_NOFOLLOW | O_CLOEXEC);
    if (lock < 0) {
        rmdir(folder.c_str());
        return;
    }
    std::error_code error;
    if (flock(lock, LOCK_EX | LOCK_NB) == 0) fs::remove_all(folder, error);
    close(lock);
}

void removeAbandoned(const std::string& parent) {
    std::error_code error;
    fs::directory_iterator entry(parent, error), end;
    while (!error && entry != end) {
        const fs::path path = entry->path();
        entry.increment(error);
        if (isOurs(path)) removeIfAbandoned(path);
    }
}

/// The folders that are there: a process that has to end at once reaches nothing but globals.
class LivingFolders {
  public:
    void add(const std::string& path) {
        const std::lock_guard lock(m_mutex);
        m_paths.insert(path);
    }
    void remove(const std::string& path) {
        const std::lock_guard lock(m_mutex);
        m_paths.erase(path);
    }
    /// Another thread may be adding a file just then, which has no place any more at the next attempt.
    void clear() {
        constexpr int kAttempts = 3;
        const std::lock_guard lock(m_mutex);
        std::error_code error;
        for (int k = 0; k < kAttempts; ++k)
            for (const std::string& path : m_paths) fs::remove_all(path, error);
    }
    static LivingFolders& all() {
        static auto* const folders = new LivingFolders;  // outlives the threads that end with the process
        return *folders;
    }

  private:
    std::mutex m_mutex;
    std::set<std::string> m_paths;
};

}  // namespace

void removeTemporaryFolders() noexcept {
    LivingFolders::all().clear();
}

/// Removes folders of killed programs, and makes and locks a new one.
TemporaryFolder::TemporaryFolder(std::string parent) : m_parent(std::move(parent)) {
    removeAbandoned(m_parent);
    constexpr int kAttempts = 100;  // others may take the folder for abandoned before it is locked
    for (int k = 0; k < kAttempts; ++k) {
        if (!tryToMake()) continue;
        LivingFolders::all().add(m_path);
        return;
    }
    throw InputError(m_parent, "no temporary folder can be made there");
}

/// File systems without locks have unlocked folders.
bool TemporaryFolder::tryToMake() {
    const auto fail = [this](const char* what, int reason) {
        throw InputError(m_parent, std::string(what) + " can be made there: " + std::strerror(reason));
    };
    m_path = (fs::path(m_parent) / kName).string();
    if (mkdtemp(m_path.data()) == nullptr) fail("no temporary folder", errno);
    m_lock = open((fs::path(m_path) / kLock).c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
    const int reason = errno;
    const bool taken = m_lock >= 0 && flock(m_lock, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
    struct stat status {};
    if (m_lock >= 0 && !taken && fstat(m_lock, &status) == 0 && status.st_nlink > 0) return true;
    if (m_lock >= 0) close(m_lock);
    rmdir(m_path.c_str());
    if (m_lock < 0 && reason != ENOENT) fail("no temporary file", reason);
    return false;
}

TemporaryFolder::~TemporaryFolder() {
    std::error_code error;
    fs::remove_all(m_path, error);
    LivingFolders::all().remove(m_path);
    close(m_lock);
}

std::string TemporaryFolder::newName(const std::string& extension) {
    return (fs::path(m_path) / (std::to_string(m_count++) + extension)).string();
}

bool isTemporary(const std::string& file) {
    return hasOurName(fs::path(file).parent_path());
}

std::string scratchFolder() {
    std::error_code error;
    const char* named = std::getenv("TMPDIR");
    const bool isEmpty = named != nullptr && *named == '\0';  // as good as none
    const fs::path folder = isEmpty ? fs::path("/tmp") : fs::temp_directory_path(error);
    if (!error) return folder.string();
    throw InputError("the folder for temporary files, " + std::string(named != nullptr ? named : "/tmp") +
                     ", does not exist (it is named by the environment variable TMPDIR)");
}

}  // namespace wend
