#include "core/base/safe_file.h"

#include <fcntl.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <mutex>
#include <optional>
#include <set>
#include <utility>

#include "core/base/checked_file.h"
#include "core/base/error.h"
#include "core/base/file_name.h"
#include "core/base/input_file.h"
#include "core/base/memory.h"
#include "core/base/stream_output.h"

namespace wend {
namespace fs = std::filesystem;

namespace {

bool isSpecialFile(const fs::path& target) {
    std::error_code error;
    const fs::file_status status = fs::status(target, error);
    return fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
}

std::string folderOf(const fs::path& target) {
    return target.has_parent_path() ? target.parent_path().string() : ".";
}

void requirePlace(const std::string& path, const std::string& target) {
    const std::string folder = folderOf(target);
    std::error_code error;
    if (!fs::is_directory(folder, error))
        throw InputError(path, {sentence("Core", "the folder %1 does not exist"), folder});
    if (fs::is_directory(target, error)) throw InputError(path, sentence("Core", "is a folder"));
    if (access(folder.c_str(), W_OK) != 0)
        throw InputError(path, {sentence("Core", "the folder %1 is not writable"), folder});
    if (const Message why = whyKept(target); !why.isEmpty()) throw InputError(path, why);
}

/// Follows links, even to a missing file, so that the target is replaced and not the link.
std::string resolved(const std::string& path) {
    constexpr int kLinks = 40;
    std::error_code error;
    if (!fs::is_symlink(path, error) || isSpecialFile(path)) return path;
    fs::path target = path;
    for (int k = 0; k < kLinks && fs::is_symlink(target, error); ++k)
        target = target.parent_path() / fs::read_symlink(target, error);
    if (fs::is_symlink(target, error)) return path;  // circular links
    const fs::path place = fs::weakly_canonical(target, error);
    return error ? target.string() : place.string();
}

/// Bytes that a user may still write to a folder's disk; none if that is not known.
std::optional<double> freeOnDisk(const std::string& folder) {
    struct statvfs disk {};
    if (statvfs(folder.c_str(), &disk) != 0) return std::nullopt;
    return static_cast<double>(disk.f_bavail) * static_cast<double>(disk.f_frsize);
}

constexpr const char* kFull = "the disk is full";

bool saysFull(const std::string& reason) {
    const auto says = [&](int error) { return reason.find(std::strerror(error)) != std::string::npos; };
    return says(ENOSPC) || says(EDQUOT) || reason.find(kFull) != std::string::npos;
}

/// Some file systems do not support fsync and do not need it.
bool isFlushed(int descriptor) {
    return fsync(descriptor) == 0 || errno == EINVAL || errno == ENOSYS || errno == ENOTSUP;
}

/// Knows whether files are replacing their targets, or have done so: a process that has to end at once must
/// not do so between two of them.
struct Placing {
    std::mutex mutex;
    bool begun = false;

    static Placing& state() {
        static auto* const placing = new Placing;  // outlives the threads that end with the process
        return *placing;
    }
};

void flushFolder(const std::string& folder) {
    const int descriptor = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor < 0) return;
    fsync(descriptor);  // the names are there; no more can be done for them
    close(descriptor);
}

}  // namespace

PendingFile::PendingFile(std::string path, Access access, const PendingFile* neighbour)
    : m_path(std::move(path)),
      m_target(resolved(m_path)),
      m_access(access),
      m_special(isSpecialFile(m_target)) {
    if (!m_special) requirePlace(m_path, m_target);
    m_temporary = m_target;
    if (!isTemporary(m_target)) makeTemporary(neighbour);
}

/// Makes the temporary file's folder, or shares that of a neighbour in the same place.
void PendingFile::makeTemporary(const PendingFile* neighbour) {
    try {
        const std::string place = m_special ? scratchFolder() : folderOf(m_target);
        const bool shares =
            neighbour != nullptr && neighbour->m_folder && neighbour->m_folder->parent() == place;
        m_folder = shares ? neighbour->m_folder : std::make_shared<TemporaryFolder>(place);
    } catch (const InputError& error) {
        fail(InputError(m_path, {sentence("Core", "cannot be written: %1"), error.message()}));
    }
    const std::string extension = fs::path(m_target).extension().string();
    m_temporary = m_folder->newName(extension.empty() ? lowerExtension(m_target) : extension);
}

PendingFile::~PendingFile() {
    std::error_code error;
    if (m_folder && !m_temporary.empty()) fs::remove(m_temporary, error);
}

PendingFile PendingFile::companion(const std::string& extension) const {
    const auto other = [&](const std::string& file) {
        return fs::path(file).replace_extension(extension).string();
    };
    PendingFile file;
    file.m_path = other(m_path);
    file.m_target = other(m_target);
    file.m_temporary = other(m_temporary);
    file.m_access = m_access;
    file.m_folder = m_folder;
    requirePlace(file.m_path, file.m_target);
    return file;
}

DiskFull::DiskFull(const std::string& file, double free)
    : InputError(file, {sentence("Core", "cannot be written: %1"),
                        Message(sentence("Core", "the disk is full, only %1 are free"), byteText(free))}) {}

/// Libraries of formats may hide the reason of a failure: then the disk counts as full if it has less left
/// than a block of theirs.
void throwExplained(const InputError& error, const std::string& folder, double given) {
    constexpr double kBlock = 4096;
    const auto left = freeOnDisk(folder.empty() ? "." : folder);
    const bool full = saysFull(error.reason()) || (left && *left < kBlock);
    if (full) throw DiskFull(error.file(), left.value_or(0) + given);
    throw error;  // NOLINT: as plain as it was
}

void PendingFile::fill(const std::function<void(const std::string&)>& write) const try {
    write(m_temporary);
} catch (const InputError& error) {
    fail(error);
}

void PendingFile::fail(int error) const {
    fail(InputError(m_path, {sentence("Core", "cannot be written: %1"), std::strerror(error)}));
}

void PendingFile::fail(const InputError& error) const {
    std::error_code unknown;
    const auto written = fs::file_size(m_temporary, unknown);
    const bool goes = m_folder && !unknown;
    throwExplained(error, folderOf(m_temporary), goes ? static_cast<double>(written) : 0);
}

/// Flushes the file to disk and sets its permissions.
void PendingFile::settle() const {
    const int descriptor = open(m_temporary.c_str(), O_RDONLY | O_NOFOLLOW | O_CLOEXEC);
    if (descriptor < 0) fail(errno);
    takeAccess(descriptor, m_target, m_access);
    const bool flushed = isFlushed(descriptor);
    const int reason = errno;
    close(descriptor);
    if (!flushed) fail(reason);
}

void PendingFile::take() {
    if (rename(m_temporary.c_str(), m_target.c_str()) != 0) fail(errno);
    m_temporary.clear();
}

void PendingFile::commit() {
    commit({this, 1});
}

void PendingFile::place() {
    settle();
    take();
    flushFolder(folderOf(m_target));
}

/// Writes to special files first: that cannot be undone but is more likely to fail, so no file has been
/// replaced then.
void PendingFile::commit(std::span<PendingFile> files) {
    for (const PendingFile& file : files)
        if (!file.m_special && file.m_folder) file.settle();
    for (const PendingFile& file : files)
        if (file.m_special) writeStream(file.m_target, readInput(file.m_temporary), file.m_path);
    std::set<std::string> folders;
    Placing& placing = Placing::state();
    std::unique_lock lock(placing.mutex);
    for (PendingFile& file : files) {
        if (file.m_special || !file.m_folder) continue;
        placing.begun = true;
        file.take();
        folders.insert(folderOf(file.m_target));
    }
    lock.unlock();
    for (const std::string& folder : folders) flushFolder(folder);
}

bool abandonPendingFiles() noexcept {
    Placing& placing = Placing::state();
    placing.mutex.lock();
    if (placing.begun) {
        placing.mutex.unlock();
        return false;
    }
    removeTemporaryFolders();  // with the lock, which is kept
    return true;
}

void writeWhole(const std::string& path, const std::function<void(const std::string&)>& write) {
    PendingFile file(path);
    file.fill(write);
    file.commit();
}

void writeWhole(const std::string& path, std::string_view bytes, Access access) {
    PendingFile file(path, access);
    file.fill([&](const std::string& temporary) {
        if (const std::string problem = writeBytes(temporary, bytes); !problem.empty())
            throw InputError(path, "cannot be written: " + problem);
    });
    file.commit();
}

}  // namespace wend
