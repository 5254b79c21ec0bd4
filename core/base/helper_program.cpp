#include "core/base/helper_program.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <thread>

namespace wend {
namespace {

// Sanitizers need more addresses than there is memory.
#ifdef WEND_SANITIZED
constexpr bool kIsSanitized = true;
#else
constexpr bool kIsSanitized = false;
#endif

void limitMemory(const char* megabytes) {
    const rlim_t bytes = static_cast<rlim_t>(std::max(64, std::atoi(megabytes))) << 20;
    const rlimit limit{bytes, bytes};
    if (!kIsSanitized) setrlimit(RLIMIT_AS, &limit);
    const rlimit noCore{0, 0};
    setrlimit(RLIMIT_CORE, &noCore);
}

/// Limits CPU time, so that the load of the machine does not decide what can be meshed.
void limitTime(const char* seconds) {
    const rlim_t soft = static_cast<rlim_t>(std::max(1, std::atoi(seconds)));
    const rlimit limit{soft, soft + 1};
    setrlimit(RLIMIT_CPU, &limit);
}

/// Ends the process as soon as the other end of a socket is closed. The signal of PR_SET_PDEATHSIG would come
/// with the end of the thread that started it.
void endWith(int socket) {
    std::thread([socket] {
        pollfd wait{socket, 0, 0};
        while (poll(&wait, 1, -1) < 0) continue;
        _exit(0);
    }).detach();
}

}  // namespace

void beginHelper(int argc, char** argv) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);  // the answer is useless once the parent has ended
    limitMemory(argc > 1 ? argv[1] : "4096");
    limitTime(argc > 2 ? argv[2] : "120");
}

int beginLinkedHelper(int argc, char** argv) {
    const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
    dup2(nowhere, STDOUT_FILENO);
    if (!kIsSanitized) dup2(nowhere, STDERR_FILENO);
    limitMemory(argc > 1 ? argv[1] : "4096");
    endWith(STDIN_FILENO);
    return STDIN_FILENO;
}

void allowTime(double seconds) {
    rusage used{};
    rlimit limit{};
    getrusage(RUSAGE_SELF, &used);
    getrlimit(RLIMIT_CPU, &limit);
    const double before = static_cast<double>(used.ru_utime.tv_sec + used.ru_stime.tv_sec);
    limit.rlim_cur = std::min(limit.rlim_max, static_cast<rlim_t>(before + std::ceil(seconds) + 1));
    setrlimit(RLIMIT_CPU, &limit);
}

std::string readAll(int fd) {
    std::string bytes;
    std::array<char, 65536> buffer;
    for (ssize_t got; (got = read(fd, buffer.data(), buffer.size())) > 0;) bytes.append(buffer.data(), got);
    return bytes;
}

bool writeAll(int fd, const std::string& bytes) {
    for (std::size_t at = 0; at < bytes.size();) {
        const ssize_t wrote = write(fd, bytes.data() + at, bytes.size() - at);
        if (wrote <= 0) return false;
        at += static_cast<std::size_t>(wrote);
    }
    return true;
}

}  // namespace wend
