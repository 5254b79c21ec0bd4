#include "core/base/checked_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

namespace wend {

namespace {

constexpr std::size_t kBuffer = 1 << 16;

}  // namespace

CheckedFile::CheckedFile(const std::string& path)
    : m_descriptor(open(path.c_str(), O_RDWR | O_CREAT | O_TRUNC | O_CLOEXEC, 0600)) {
    if (m_descriptor < 0) fail(errno);
    m_buffer.reserve(kBuffer);
}

CheckedFile::~CheckedFile() {
    if (m_descriptor >= 0) close(m_descriptor);
}

void CheckedFile::fail(int error) {
    if (m_error == 0) m_error = error != 0 ? error : EIO;
}

void CheckedFile::write(std::int64_t at, const void* bytes, std::size_t size) {
    const auto* from = static_cast<const char*>(bytes);
    const bool follows = at == m_bufferAt + static_cast<std::int64_t>(m_buffer.size());
    if (!follows || m_buffer.size() + size > kBuffer) flush();
    m_end = std::max(m_end, at + static_cast<std::int64_t>(size));
    if (size > kBuffer) return put(at, from, size);
    if (m_buffer.empty()) m_bufferAt = at;
    m_buffer.append(from, size);
}

void CheckedFile::flush() {
    put(m_bufferAt, m_buffer.data(), m_buffer.size());
    m_buffer.clear();
}

/// A write may be partial, such as before the end of a disk: writing the rest reports the reason.
void CheckedFile::put(std::int64_t at, const char* bytes, std::size_t size) {
    while (size > 0 && !failed()) {
        const ssize_t count = pwrite(m_descriptor, bytes, size, at);
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) return fail(count < 0 ? errno : ENOSPC);
        bytes += count, at += count, size -= static_cast<std::size_t>(count);
    }
}

std::size_t CheckedFile::read(std::int64_t at, void* bytes, std::size_t size) {
    flush();
    const ssize_t count = failed() ? 0 : pread(m_descriptor, bytes, size, at);
    return count > 0 ? static_cast<std::size_t>(count) : 0;
}

std::string CheckedFile::finish() {
    flush();
    struct stat now {};
    if (!failed() && fstat(m_descriptor, &now) != 0) fail(errno);
    if (!failed() && now.st_size != m_end) fail(EIO);
    // A file on another machine may be refused only here.
    if (m_descriptor >= 0 && close(std::exchange(m_descriptor, -1)) != 0) fail(errno);
    return failed() ? std::strerror(m_error) : "";
}

std::string writeBytes(const std::string& path, std::string_view bytes) {
    CheckedFile file(path);
    file.write(0, bytes.data(), bytes.size());
    return file.finish();
}

}  // namespace wend
