#include "core/base/stream_output.h"

#include <fcntl.h>
#include <limits.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "core/base/error.h"
#include "core/base/input_file.h"

namespace wend {

namespace {

constexpr int kLook = 100;  // milliseconds between two looks at whether to stop

[[noreturn]] void fail(const std::string& name, const std::string& reason) {
    throw InputError(name, {sentence("Core", "cannot be written: %1"), reason});
}

/// Returns whether a pipe has enough room for a piece.
bool isReady(int descriptor) {
    pollfd wait{descriptor, POLLOUT, 0};
    return poll(&wait, 1, kLook) > 0;
}

}  // namespace

void writeStream(int descriptor, std::string_view bytes, const std::string& name) {
    while (!bytes.empty()) {
        requireReading();
        if (!isReady(descriptor)) continue;
        const ssize_t count = write(descriptor, bytes.data(), std::min<std::size_t>(bytes.size(), PIPE_BUF));
        if (count < 0 && (errno == EINTR || errno == EAGAIN)) continue;
        if (count < 0) fail(name, std::strerror(errno));
        bytes.remove_prefix(static_cast<std::size_t>(count));
    }
}

void writeStream(const std::string& path, std::string_view bytes, const std::string& name) {
    const int descriptor = open(path.c_str(), O_WRONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
    if (descriptor < 0) fail(name, errno == ENXIO ? "nobody reads from it" : std::strerror(errno));
    try {
        writeStream(descriptor, bytes, name);
    } catch (...) {
        close(descriptor);
        throw;
    }
    if (close(descriptor) != 0) fail(name, std::strerror(errno));
}

}  // namespace wend
