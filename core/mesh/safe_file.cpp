#include "core/mesh/safe_file.h"

#include <unistd.h>

#include <filesystem>

#include "core/mesh/error.h"

namespace wend {
namespace fs = std::filesystem;

void writeWhole(const std::string& path, const std::function<void(const std::string&)>& write) {
    const fs::path target(path);
    const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
    if (!fs::is_directory(folder))
        throw InputError(path, "the folder " + folder.string() + " does not exist");
    if (fs::is_directory(target)) throw InputError(path, "is a folder");
    if (access(folder.c_str(), W_OK) != 0)
        throw InputError(path, "the folder " + folder.string() + " is not writable");

    const fs::path temporary = folder / ("." + target.stem().string() + "." + std::to_string(getpid()) +
                                         ".part" + target.extension().string());
    std::error_code error;
    try {
        write(temporary.string());
        fs::rename(temporary, target, error);
        if (error) throw InputError(path, "cannot be written: " + error.message());
    } catch (...) {
        fs::remove(temporary, error);
        throw;
    }
}

}  // namespace wend
