#include "core/base/input_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <optional>
#include <utility>

#include "core/base/error.h"

namespace wend {
namespace {

constexpr std::uint64_t kPiece = 1 << 20;  // bytes between checks for cancellation

std::atomic<bool> readingStops = false;

/// Returns the kind of a special file; nothing for a regular file.
std::optional<Message> oddKind(mode_t mode) {
    if (S_ISREG(mode)) return std::nullopt;
    if (S_ISDIR(mode)) return sentence("Core", "is a folder");
    if (S_ISFIFO(mode)) return sentence("Core", "is a pipe, not a file");
    if (S_ISSOCK(mode)) return "is a socket, not a file";
    return sentence("Core", "is a device, not a file");
}

void requireRegular(const std::string& path, const struct stat& status) {
    if (const auto kind = oddKind(status.st_mode)) throw InputError(path, *kind);
}

Message reasonOf(int error) {
    if (error == ENOENT) return sentence("Core", "does not exist");
    if (error == ELOOP) return sentence("Core", "is a symbolic link that leads back to itself");
    return {sentence("Core", "cannot be read: %1"), std::strerror(error)};
}

std::string room(std::uint64_t size, const std::string& path) try {
    return std::string(size, '\0');
} catch (const std::exception&) {  // too long for a string, or for the available memory
    throw OutOfMemory(path);
}

}  // namespace

InputFile::InputFile(std::string path) : m_path(std::move(path)) {
    if (m_path.find('\0') != std::string::npos) throw InputError(m_path, "has a NUL character in its name");
    struct stat status {};
    if (stat(m_path.c_str(), &status) != 0) throw InputError(m_path, reasonOf(errno));
    requireRegular(m_path, status);  // before it is opened, which some devices take for an order
    m_descriptor = open(m_path.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
    if (m_descriptor < 0) throw InputError(m_path, reasonOf(errno));
    const bool known = fstat(m_descriptor, &status) == 0;
    const auto kind = known ? oddKind(status.st_mode) : Message("cannot be read");
    m_size = static_cast<std::uint64_t>(status.st_size);
    if (!kind) return;
    close(m_descriptor);
    throw InputError(m_path, *kind);
}

InputFile::InputFile(std::string path, std::string content)
    : m_path(std::move(path)), m_size(content.size()), m_content(std::move(content)) {}

InputFile::~InputFile() {
    if (m_descriptor >= 0) close(m_descriptor);
}

/// Reads in pieces, so that stopReading() takes effect within large files.
std::string InputFile::bytes(std::uint64_t offset, std::uint64_t count) const {
    if (m_descriptor < 0) return offset < m_size ? m_content.substr(offset, count) : std::string();
    std::string bytes = room(std::min(count, m_size - std::min(offset, m_size)), m_path);
    std::uint64_t done = 0;
    while (done < bytes.size()) {
        requireReading();
        const ssize_t got = pread(m_descriptor, bytes.data() + done, std::min(bytes.size() - done, kPiece),
                                  static_cast<off_t>(offset + done));
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) throw InputError(m_path, reasonOf(errno));
        if (got == 0) break;  // truncated meanwhile
        done += static_cast<std::uint64_t>(got);
    }
    bytes.resize(done);
    return bytes;
}

std::string readInput(const std::string& path) {
    return InputFile(path).bytes();
}

void stopReading(bool stop) noexcept {
    readingStops = stop;
}

void requireReading() {
    if (readingStops) throw Cancelled();
}

}  // namespace wend
