#include "core/mesh/safe_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <set>
#include <utility>

#include "core/mesh/checked_file.h"
#include "core/mesh/error.h"
#include "core/mesh/input_file.h"
#include "core/mesh/stream_output.h"

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
    if (!fs::is_directory(folder, error)) throw InputError(path, "the folder " + folder + " does not exist");
    if (fs::is_directory(target, error)) throw InputError(path, "is a folder");
    if (access(folder.c_str(), W_OK) != 0)
        throw InputError(path, "the folder " + folder + " is not writable");
    if (const std::string why = whyKept(target); !why.empty()) throw InputError(path, why);
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

[[noreturn]] void fail(const std::string& path, const std::string& reason) {
    throw InputError(path, "cannot be written: " + reason);
}

/// Some file systems do not support fsync and do not need it.
bool isFlushed(int descriptor) {
    return fsync(descriptor) == 0 || errno == EINVAL || errno == ENOSYS || errno == ENOTSUP;
}

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

void PendingFile::makeTemporary(const PendingFile* neighbour) {
    try {
        const std::string place = m_special ? scratchFolder() : folderOf(m_target);
        const bool shares =
            neighbour != nullptr && neighbour->m_folder && neighbour->m_folder->parent() == place;
        m_folder = shares ? neighbour->m_folder : std::make_shared<TemporaryFolder>(place);
    } catch (const InputError& error) {
        fail(m_path, error.reason());
    }
    m_temporary = m_folder->newName(fs::path(m_target).extension().string());
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

/// Flushes the file to disk and sets its permissions.
void PendingFile::settle() const {
    const int descriptor = open(m_temporary.c_str(), O_RDONLY | O_NOFOLLOW | O_CLOEXEC);
    if (descriptor < 0) fail(m_path, std::strerror(errno));
    takeAccess(descriptor, m_target, m_access);
    const bool flushed = isFlushed(descriptor);
    const int reason = errno;
    close(descriptor);
    if (!flushed) fail(m_path, std::strerror(reason));
}

void PendingFile::take() {
    if (rename(m_temporary.c_str(), m_target.c_str()) != 0) fail(m_path, std::strerror(errno));
    m_temporary.clear();
}

void PendingFile::commit() {
    commit({this, 1});
}

/// Writes to special files first: that cannot be undone but is more likely to fail, so no file has been
/// replaced then.
void PendingFile::commit(std::span<PendingFile> files) {
    for (const PendingFile& file : files)
        if (!file.m_special && file.m_folder) file.settle();
    for (const PendingFile& file : files)
        if (file.m_special) writeStream(file.m_target, readInput(file.m_temporary), file.m_path);
    std::set<std::string> folders;
    for (PendingFile& file : files) {
        if (file.m_special || !file.m_folder) continue;
        file.take();
        folders.insert(folderOf(file.m_target));
    }
    for (const std::string& folder : folders) flushFolder(folder);
}

void writeWhole(const std::string& path, const std::function<void(const std::string&)>& write) {
    PendingFile file(path);
    write(file.temporary());
    file.commit();
}

void writeWhole(const std::string& path, std::string_view bytes, Access access) {
    PendingFile file(path, access);
    if (const std::string problem = writeBytes(file.temporary(), bytes); !problem.empty())
        fail(path, problem);
    file.commit();
}

}  // namespace wend
