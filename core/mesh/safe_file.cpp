#include "core/mesh/safe_file.h"

#include <fcntl.h>
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

/// Makes an empty file, or fails if there is anything of that name already, be it a link.
bool create(const fs::path& file) {
    const int descriptor = open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor >= 0) close(descriptor);
    return descriptor >= 0;
}

/// ".name.PROCESS-0.part.ext" or the first of its kind that is free.
std::string createBeside(const std::string& path, const fs::path& target) {
    const std::string start = "." + target.stem().string() + "." + std::to_string(getpid()) + "-";
    for (int k = 0; k < 1000; ++k) {
        const fs::path file =
            folderFor(target) / (start + std::to_string(k) + ".part" + target.extension().string());
        if (create(file)) return file.string();
        if (errno != EEXIST) break;
    }
    throw InputError(path, std::string("cannot be written: ") + std::strerror(errno));
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

PendingFile::PendingFile(std::string path) : m_path(std::move(path)) {
    const fs::path target = resolved(m_path);
    requireFolder(m_path, target);
    m_target = target.string();
    if (wend::isSpecial(target)) {
        m_folder.emplace(folderFor(target).string());
        m_temporary = (fs::path(m_folder->path()) / target.filename()).string();
    } else {
        m_temporary = createBeside(m_path, target);
    }
}

PendingFile::PendingFile(std::string path, std::string target, std::string temporary)
    : m_path(std::move(path)), m_target(std::move(target)), m_temporary(std::move(temporary)) {
    if (create(m_temporary)) return;
    throw InputError(m_path, std::string("cannot be written: ") + std::strerror(errno));
}

PendingFile::PendingFile(PendingFile&& other) noexcept
    : m_path(std::move(other.m_path)),
      m_target(std::move(other.m_target)),
      m_temporary(std::exchange(other.m_temporary, {})),
      m_folder(std::move(other.m_folder)) {}

PendingFile::~PendingFile() {
    std::error_code error;
    if (!m_temporary.empty()) fs::remove(m_temporary, error);
}

PendingFile PendingFile::companion(const std::string& extension) const {
    const auto other = [&](const std::string& file) {
        return fs::path(file).replace_extension(extension).string();
    };
    return {other(m_path), other(m_target), other(m_temporary)};
}

void PendingFile::commit() {
    if (isSpecial()) return copyInto(m_path, m_temporary, m_target);
    std::error_code error;
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
