#include "core/mesh/safe_file.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <utility>

#include "core/mesh/error.h"

namespace wend {
namespace fs = std::filesystem;

namespace {

bool isSpecial(const fs::path& target) {
    std::error_code error;
    const fs::file_status status = fs::status(target, error);
    return fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
}

fs::path folderFor(const fs::path& target) {
    if (isSpecial(target)) return fs::temp_directory_path();
    return target.has_parent_path() ? target.parent_path() : fs::path(".");
}

void requireFolder(const std::string& path, const fs::path& target) {
    const fs::path folder = folderFor(target);
    if (!fs::is_directory(folder))
        throw InputError(path, "the folder " + folder.string() + " does not exist");
    if (fs::is_directory(target)) throw InputError(path, "is a folder");
    if (access(folder.c_str(), W_OK) != 0)
        throw InputError(path, "the folder " + folder.string() + " is not writable");
}

/// Follows links, so that the file is replaced and not the link.
fs::path resolved(const fs::path& path) {
    std::error_code error;
    if (!fs::is_symlink(path, error) || isSpecial(path)) return path;
    const fs::path target = fs::weakly_canonical(path, error);
    return error ? path : target;
}

void copyInto(const std::string& path, const fs::path& from, const fs::path& target) {
    std::ifstream in(from, std::ios::binary);
    std::ofstream out(target, std::ios::binary);
    if (in.peek() != std::ifstream::traits_type::eof()) out << in.rdbuf();
    out.close();
    if (!in || !out) throw InputError(path, std::string("cannot be written: ") + std::strerror(errno));
}

}  // namespace

PendingFile::PendingFile(std::string path) : m_path(std::move(path)) {
    const fs::path target = resolved(m_path);
    requireFolder(m_path, target);
    const std::string name = "." + target.stem().string() + "." + std::to_string(getpid()) + ".part";
    m_target = target.string();
    m_temporary = (folderFor(target) / (name + target.extension().string())).string();
}

PendingFile::PendingFile(PendingFile&& other) noexcept
    : m_path(std::move(other.m_path)),
      m_target(std::move(other.m_target)),
      m_temporary(std::exchange(other.m_temporary, {})) {}

PendingFile::~PendingFile() {
    std::error_code error;
    if (!m_temporary.empty()) fs::remove(m_temporary, error);
}

void PendingFile::commit() {
    std::error_code error;
    if (isSpecial(m_target)) return copyInto(m_path, m_temporary, m_target);
    if (const fs::file_status old = fs::status(m_target, error); fs::exists(old))
        fs::permissions(m_temporary, old.permissions(), error);
    fs::rename(m_temporary, m_target, error);
    if (error) throw InputError(m_path, "cannot be written: " + error.message());
    m_temporary.clear();
}

void writeWhole(const std::string& path, const std::function<void(const std::string&)>& write) {
    PendingFile file(path);
    write(file.temporary());
    file.commit();
}

}  // namespace wend
