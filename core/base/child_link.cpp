#include "core/base/child_link.h"

#include <poll.h>
#include <sys/socket.h>
#include <sys/wait.h>

#include <array>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <new>

#include "core/base/child_parts.h"

extern char** environ;

namespace wend {
namespace {

constexpr int kWait = 50;                                   // in milliseconds
constexpr std::uint64_t kLongest = std::uint64_t(1) << 30;  // bytes of a message

/// Receives exactly `size` bytes. Returns false if the other end is closed, or `isAwaited` returns false.
bool receiveBytes(int socket, char* bytes, std::size_t size, const std::function<bool()>& isAwaited) {
    for (std::size_t done = 0; done < size;) {
        pollfd wait{socket, POLLIN, 0};
        if (poll(&wait, 1, isAwaited ? kWait : -1) <= 0) {
            if (isAwaited && !isAwaited()) return false;
            continue;
        }
        const ssize_t got = recv(socket, bytes + done, size - done, MSG_DONTWAIT);
        if (got == 0 || (got < 0 && errno != EINTR && errno != EAGAIN)) return false;
        if (got > 0) done += static_cast<std::size_t>(got);
    }
    return true;
}

bool sendBytes(int socket, const char* bytes, std::size_t size) {
    for (std::size_t done = 0; done < size;) {
        const ssize_t sent = ::send(socket, bytes + done, size - done, MSG_NOSIGNAL);
        if (sent < 0 && errno != EINTR) return false;
        if (sent > 0) done += static_cast<std::size_t>(sent);
    }
    return true;
}

}  // namespace

bool sendMessage(int socket, const std::string& message) {
    const std::uint64_t size = message.size();
    return sendBytes(socket, reinterpret_cast<const char*>(&size), sizeof size) &&
           sendBytes(socket, message.data(), message.size());
}

bool receiveMessage(int socket, std::string& message, const std::function<bool()>& isAwaited) {
    std::uint64_t size = 0;
    if (!receiveBytes(socket, reinterpret_cast<char*>(&size), sizeof size, isAwaited) || size > kLongest)
        return false;
    message.resize(size);
    return receiveBytes(socket, message.data(), size, isAwaited);
}

struct ChildLink::Process {
    Descriptor socket;
    pid_t id = 0;
    ChildResult result;

    /// Starts the helper with one end of a socket pair as its standard input; its other descriptors are
    /// closed.
    void start(const std::string& path, int megabytes) {
        std::array<int, 2> ends{};
        if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) return fail(errno);
        socket.reset(ends[0]);
        const Descriptor other(ends[1]);
        posix_spawn_file_actions_t actions;
        posix_spawn_file_actions_init(&actions);
        posix_spawn_file_actions_adddup2(&actions, other.get(), STDIN_FILENO);
        std::string limit = std::to_string(megabytes);
        std::array<char*, 3> arguments{const_cast<char*>(path.c_str()), limit.data(), nullptr};
        const Attributes attributes;
        const int error =
            posix_spawn(&id, path.c_str(), &actions, attributes.get(), arguments.data(), environ);
        posix_spawn_file_actions_destroy(&actions);
        if (error != 0) fail(error);
    }

    void fail(int error) {
        id = 0;
        result = {ChildResult::End::NotStarted, error, {}};
    }

    void kill(ChildResult::End reason) {
        if (id <= 0) return;
        ::kill(-id, SIGKILL);
        ::kill(id, SIGKILL);
        wait(reason);
    }

    /// Waits for its end, which is due, and kills it if it does not come within seconds.
    void waitBriefly() {
        constexpr int kTimes = 400, kEach = 5000;  // in microseconds
        siginfo_t info{};
        for (int k = 0; k < kTimes && info.si_pid == 0; ++k) {
            if (waitid(P_PID, static_cast<id_t>(id), &info, WEXITED | WNOHANG | WNOWAIT) != 0) break;
            if (info.si_pid == 0) usleep(kEach);
        }
        if (info.si_pid == 0) ::kill(-id, SIGKILL);
        wait(ChildResult::End::Exited);
    }

    /// `reason` is how it ended unless it did so by itself.
    void wait(ChildResult::End reason) {
        int status = 0;
        while (waitpid(id, &status, 0) < 0 && errno == EINTR) continue;
        id = 0;
        result.end = reason;
        result.code = WIFSIGNALED(status) ? WTERMSIG(status) : WEXITSTATUS(status);
        if (reason != ChildResult::End::Exited || !WIFSIGNALED(status)) return;
        result.end = result.code == SIGXCPU ? ChildResult::End::TimedOut : ChildResult::End::Signalled;
    }
};

ChildLink::ChildLink(const std::string& path, int megabytes) : m_process(std::make_unique<Process>()) {
    m_process->start(path, megabytes);
}

ChildLink::~ChildLink() {
    m_process->kill(ChildResult::End::Stopped);
}

bool ChildLink::send(const std::string& message) {
    return m_process->id > 0 && sendMessage(m_process->socket.get(), message);
}

/// Receives a message while watching whether the helper is idle, and kills it if so.
bool ChildLink::receive(std::string& message, double idleSeconds, const std::function<void()>& goOn) {
    if (m_process->id <= 0) return false;
    IdleWatch watch(m_process->id, idleSeconds);
    bool isIdle = false;
    const auto isAwaited = [&] {
        goOn();
        isIdle = watch.isIdle(0);
        return !isIdle;
    };
    if (receiveMessage(m_process->socket.get(), message, isAwaited)) return true;
    if (isIdle) m_process->kill(ChildResult::End::Idle);
    return false;
}

ChildResult ChildLink::end() {
    m_process->socket.reset();
    if (m_process->id > 0) m_process->waitBriefly();
    return m_process->result;
}

}  // namespace wend
