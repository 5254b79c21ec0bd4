#include "app/output/output_set.h"

#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <filesystem>

#include "app/project/file/text_file.h"
#include "core/base/error.h"
#include "core/base/file_name.h"
#include "core/base/input_file.h"
#include "core/base/stream_output.h"

namespace wend {
namespace fs = std::filesystem;

namespace {

/// Returns the extensions of the files that are written along: TetGen's come in pairs, maybe with two more.
std::vector<std::string> partnersOf(const std::string& path) {
    const std::string extension = lowerExtension(path);
    if (extension == ".node") return {".ele", ".face", ".edge"};
    if (extension == ".ele") return {".node", ".face", ".edge"};
    return {};
}

/// Returns whether an error is about another file than the one that is written, or one beside it.
bool isOfOtherFile(const InputError& error, const std::string& file) {
    const std::string stem = fs::path(file).replace_extension().string();
    return !error.file().empty() && !error.file().starts_with(stem);
}

/// Calls `write` with that file; errors name `path` instead, unless they are about a file that is read.
void writeTo(const std::string& file, const std::string& path, const OutputSet::Write& write) try {
    write(file);
} catch (const InputError& error) {
    if (isOfOtherFile(error, file)) throw;
    std::string reason = error.reason();
    const auto at = reason.find(file);
    if (at == std::string::npos) throw InputError(path, error.message());
    throw InputError(path, reason.replace(at, file.size(), path));
} catch (const OutOfMemory& error) {
    const std::string what = error.what(), name = file + ": ";
    if (!what.starts_with(name)) throw;
    throw OutOfMemory(path, what.substr(name.size()));
}

}  // namespace

std::string frameName(const std::string& pattern, int number) {
    const auto last = pattern.find_last_of('#');
    auto first = last;
    while (first > 0 && pattern[first - 1] == '#') --first;
    std::string digits = std::to_string(number);
    if (const std::size_t width = last - first + 1; digits.size() < width)
        digits.insert(0, width - digits.size(), '0');
    return pattern.substr(0, first) + digits + pattern.substr(last + 1);
}

std::optional<int> frameNumber(const std::string& pattern, const std::string& name) {
    const auto last = pattern.find_last_of('#');
    const std::size_t first = pattern.find_last_not_of('#', last) + 1, after = pattern.size() - last - 1;
    if (name.size() < first + after) return std::nullopt;
    int number = 0;
    const char* end = name.data() + name.size() - after;
    const auto read = std::from_chars(name.data() + first, end, number);
    if (read.ec != std::errc() || read.ptr != end || number < 0 || frameName(pattern, number) != name)
        return std::nullopt;
    return number;
}

std::vector<std::string> writtenAlong(const std::string& path) {
    std::vector<std::string> files{path};
    for (const std::string& other : partnersOf(path))
        files.push_back(fs::path(path).replace_extension(other).string());
    // The stub of an OpenFOAM case stands for the files beside it, of which the points can be written.
    if (fs::path(path).extension() == ".foam")
        files.push_back((fs::path(path).parent_path() / "constant" / "polyMesh" / "points").string());
    return files;
}

void requirePlaces(const std::vector<std::string>& paths) {
    for (const std::string& path : paths)
        if (!path.empty() && path != "-") PendingFile{path};
}

void OutputSet::add(const std::string& path, const std::string& extension, const Write& write) {
    if (path == "-") {
        const TemporaryFolder folder(scratchFolder());
        const std::string file = (fs::path(folder.path()) / ("output" + extension)).string();
        writeTo(file, path, write);
        m_standardOutput = readTextFile(file);
        return;
    }
    PendingFile file(path, Access::Usual, m_files.empty() ? nullptr : &m_files.back());
    std::vector<PendingFile> partners;
    for (const std::string& other : partnersOf(path))
        if (!file.isSpecial()) partners.push_back(file.companion(other));
    file.fill([&](const std::string& temporary) { writeTo(temporary, path, write); });
    for (PendingFile& partner : partners)
        if (fs::exists(partner.temporary())) m_files.push_back(std::move(partner));
    m_files.push_back(std::move(file));
}

std::string OutputSet::begin(const std::string& path) {
    m_files.emplace_back(path, Access::Usual, m_files.empty() ? nullptr : &m_files.back());
    return m_files.back().temporary();
}

void OutputSet::extend(const std::string& path, const std::function<void()>& write) {
    const auto file = std::ranges::find(m_files, path, &PendingFile::path);
    file->fill([&](const std::string& temporary) {
        writeTo(temporary, path, [&](const std::string&) { write(); });
    });
}

void OutputSet::discard() {
    m_files.clear();
    m_standardOutput.reset();
}

void OutputSet::commit() {
    // First what is the likelier to fail, a closed pipe: then no file has been replaced.
    if (m_standardOutput) writeStream(STDOUT_FILENO, *m_standardOutput, "-");
    m_standardOutput.reset();
    PendingFile::commit(m_files);
    m_files.clear();
}

}  // namespace wend
