#include "app/session/own_files.h"

#include <filesystem>

#include "app/session/output_set.h"

namespace wend {
namespace {

namespace fs = std::filesystem;

/// The same file, or the same place where there is none yet.
bool isSame(const fs::path& a, const fs::path& b) {
    std::error_code error;
    if (fs::equivalent(a, b, error) && !error) return true;
    const auto place = [](const fs::path& path) {
        std::error_code unknown;
        const fs::path found = fs::weakly_canonical(fs::absolute(path, unknown), unknown);
        return unknown ? path : found;
    };
    return place(a) == place(b);
}

std::string cellsFileOf(const Project& project) {
    return std::visit([](const auto& design) { return design.material.cellsFile; }, project.design);
}

std::vector<std::pair<OwnFile, std::string>> ownFiles(const Document& document) {
    const Project& project = *document.project();
    const Domain& domain = project.domain;
    const std::string folder = document.folder().toStdString();
    std::vector<std::pair<OwnFile, std::string>> files;
    const auto add = [&](OwnFile kind, const std::string& file) {
        if (!file.empty()) files.emplace_back(kind, pathIn(folder, file));
    };
    add(OwnFile::Project, document.path().toStdString());
    add(domain.kind == DomainKind::Image ? OwnFile::Picture : OwnFile::Mesh, domain.path);
    add(OwnFile::Picture, domain.texture);
    add(OwnFile::Sizes, domain.sizesFile);
    add(OwnFile::Detail, domain.detail);
    add(OwnFile::Material, cellsFileOf(project));
    return files;
}

bool isOneOfFrames(const std::string& pattern, const std::string& file, int count) {
    const fs::path place(pattern);
    const std::string name = place.filename().string();
    if (name.find('#') == std::string::npos) return false;
    const auto number = frameNumber(name, fs::path(file).filename().string());
    return number && *number < count && isSame(place.parent_path() / fs::path(file).filename(), file);
}

}  // namespace

std::optional<OwnFile> ownFileAt(const Document& document, const QString& path, int count) {
    const std::string target = path.toStdString();
    const bool sequence = path.contains('#');
    for (const auto& [kind, file] : ownFiles(document))
        if (sequence ? isOneOfFrames(target, file, count) : isSame(target, file)) return kind;
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
