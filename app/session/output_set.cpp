#include "app/session/output_set.h"

#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <filesystem>

#include "app/document/text_file.h"
#include "core/mesh/error.h"

namespace wend {
namespace fs = std::filesystem;

namespace {

/// TetGen's files come in pairs: the other one is written along.
std::optional<std::string> partnerOf(const std::string& path) {
    const std::string extension = lowerExtension(path);
    if (extension == ".node") return fs::path(path).replace_extension(".ele").string();
    if (extension == ".ele") return fs::path(path).replace_extension(".node").string();
    return std::nullopt;
}

std::string standardOutputFile(const std::string& extension) {
    return (fs::temp_directory_path() / ("wend-output-" + std::to_string(getpid()) + extension)).string();
}

void print(const std::string& bytes) {
    for (std::size_t done = 0; done < bytes.size();) {
        const ssize_t count = ::write(STDOUT_FILENO, bytes.data() + done, bytes.size() - done);
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) throw InputError("-", std::string("cannot be written: ") + std::strerror(errno));
        done += count;
    }
}

}  // namespace

std::string lowerExtension(const std::string& path) {
    std::string extension = fs::path(path).extension().string();
    std::ranges::transform(extension, extension.begin(), [](unsigned char c) { return std::tolower(c); });
    return extension;
}

void requirePlace(const std::string& path) {
    if (path != "-") PendingFile{path};
}

void OutputSet::add(const std::string& path, const std::string& extension, const Write& write) {
    const bool toStandardOutput = path == "-";
    PendingFile file(toStandardOutput ? standardOutputFile(extension) : path);
    std::vector<PendingFile> files;
    if (const auto partner = partnerOf(file.path())) files.emplace_back(*partner);
    try {
        write(file.temporary());
    } catch (const InputError& error) {
        std::string reason = error.reason();
        if (const auto at = reason.find(file.temporary()); at != std::string::npos)
            reason.replace(at, file.temporary().size(), path);
        throw InputError(path, reason);
    }
    if (toStandardOutput) {
        m_standardOutput = readTextFile(file.temporary());
        return;
    }
    files.push_back(std::move(file));
    for (PendingFile& one : files) m_files.push_back(std::move(one));
}

void OutputSet::commit() {
    for (PendingFile& file : m_files) file.commit();
    m_files.clear();
    if (m_standardOutput) print(*m_standardOutput);
    m_standardOutput.reset();
}

}  // namespace wend
