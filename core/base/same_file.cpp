#include "core/base/same_file.h"

#include <sys/stat.h>

#include <filesystem>

namespace wend {
namespace fs = std::filesystem;

namespace {

bool sameNode(const std::string& a, const std::string& b) {
    struct stat first {
    }, second{};
    return stat(a.c_str(), &first) == 0 && stat(b.c_str(), &second) == 0 && first.st_dev == second.st_dev &&
           first.st_ino == second.st_ino;
}

bool isFile(const std::string& name) {
    return !name.empty() && name != "-";
}

}  // namespace

std::string canonicalName(const std::string& path) {
    std::error_code error;
    const fs::path whole = fs::absolute(path, error);
    const fs::path name = error ? fs::path(path) : fs::weakly_canonical(whole, error);
    return error ? path : name.string();
}

/// A folder may have two canonical names where it is mounted twice.
bool sameFile(const std::string& a, const std::string& b) {
    if (!isFile(a) || !isFile(b)) return false;
    if (sameNode(a, b)) return true;
    const fs::path first = canonicalName(a), second = canonicalName(b);
    return first == second || (first.filename() == second.filename() &&
                               sameNode(first.parent_path().string(), second.parent_path().string()));
}

}  // namespace wend
