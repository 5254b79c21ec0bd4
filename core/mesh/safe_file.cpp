#include "core/mesh/safe_file.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <utility>
#include <vector>

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

TemporaryFolder folderBeside(const std::string& path, const fs::path& target) try {
    requireFolder(path, target);
    return TemporaryFolder(folderFor(target).string());
} catch (const fs::filesystem_error& error) {
    throw InputError(path, "cannot be written: " + error.code().message());
}

void copyInto(const std::string& path, const fs::path& from, const fs::path& target) {
    std::ifstream in(from, std::ios::binary);
    std::ofstream out(target, std::ios::binary);
    if (in.peek() != std::ifstream::traits_type::eof()) out << in.rdbuf();
    out.close();
    if (!in || !out) throw InputError(path, std::string("cannot be written: ") + std::strerror(errno));
}

}  // namespace

TemporaryFolder::TemporaryFolder(const std::string& parent)
    : m_path((fs::path(parent) / ".wend-XXXXXX").string()) {
    if (mkdtemp(m_path.data()) == nullptr)
        throw fs::filesystem_error("no temporary folder", parent, {errno, std::generic_category()});
}

TemporaryFolder::TemporaryFolder(TemporaryFolder&& other) noexcept
    : m_path(std::exchange(other.m_path, {})) {}

TemporaryFolder::~TemporaryFolder() {
    std::error_code error;
    if (!m_path.empty()) fs::remove_all(m_path, error);
}

PendingFile::PendingFile(std::string path)
    : m_path(std::move(path)),
      m_target(resolved(m_path).string()),
      m_special(wend::isSpecial(m_target)),
      m_folder(folderBeside(m_path, m_target)),
      m_temporary((fs::path(m_folder.path()) / fs::path(m_target).filename()).string()) {}

void PendingFile::commit() {
    if (m_special) return copyInto(m_path, m_temporary, m_target);
    if (!fs::exists(m_temporary)) throw InputError(m_path, "was not written");
    std::vector<fs::path> written;
    for (const auto& entry : fs::directory_iterator(m_folder.path()))
        if (entry.is_regular_file()) written.push_back(entry.path());
    for (const fs::path& file : written) {
        const fs::path target = fs::path(m_target).replace_filename(file.filename());
        std::error_code error;
        if (const fs::file_status old = fs::status(target, error); fs::exists(old))
            fs::permissions(file, old.permissions(), error);
        fs::rename(file, target, error);
        if (error) throw InputError(m_path, "cannot be written: " + error.message());
    }
}

void writeWhole(const std::string& path, const std::function<void(const std::string&)>& write) {
    PendingFile file(path);
    write(file.temporary());
    file.commit();
}

}  // namespace wend
