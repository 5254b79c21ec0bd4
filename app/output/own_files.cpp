#include "app/output/own_files.h"

#include <filesystem>

#include "app/output/output_set.h"
#include "app/project/design.h"
#include "app/project/domain.h"
#include "core/base/same_file.h"

namespace wend {
namespace {

namespace fs = std::filesystem;

bool isOneOfFrames(const std::string& pattern, const std::string& file, int count) {
    const fs::path place(pattern);
    const std::string name = place.filename().string();
    if (name.find('#') == std::string::npos) return false;
    const auto number = frameNumber(name, fs::path(file).filename().string());
    return number && *number < count &&
           sameFile((place.parent_path() / fs::path(file).filename()).string(), file);
}

}  // namespace

std::optional<OwnFile> ownFileAt(const Document& document, const QString& path, int count) {
    const std::string target = path.toStdString();
    const bool sequence = path.contains('#');
    for (const auto& [kind, file] :
         inputsOf(*document.project(), document.path().toStdString(), document.folder().toStdString()))
        if (sequence ? isOneOfFrames(target, file, count) : sameFile(target, file)) return kind;
    return std::nullopt;
}

int existingFrames(const QString& pattern, int count) {
    const fs::path place(pattern.toStdString());
    int found = 0;
    if (place.filename().string().find('#') == std::string::npos) return found;
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(place.parent_path(), error)) {
        const auto number = frameNumber(place.filename().string(), entry.path().filename().string());
        found += number && *number < count ? 1 : 0;
    }
    return found;
}

}  // namespace wend
