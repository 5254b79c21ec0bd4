#include "core/base/file_name.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

namespace wend {

std::string lowerExtension(const std::string& path) {
    std::string extension = std::filesystem::path(path).extension().string();
    if (std::filesystem::path(path).filename() == "points") return ".foam";
    std::ranges::transform(extension, extension.begin(), [](unsigned char c) { return std::tolower(c); });
    return extension;
}

}  // namespace wend
