#include "core/base/child_process.h"

#include <dlfcn.h>
#include <fcntl.h>
#include <poll.h>
#include <pthread.h>
#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <vector>

#include "core/base/child_parts.h"

extern char** environ;

namespace wend {
namespace {

using Clock = std::chrono::steady_clock;

class Child {
  public:
    /// Starts the helper with pipes to its standard input and from its standard output.
    bool start(const std::string& path, int megabytes, double processorSeconds) {
        Descriptor childIn, childOut;
        if (!makePipe(childIn, m_in) || !makePipe(m_out, childOut)) return false;
        posix_spawn_file_actions_t actions;
        posix_spawn_file_actions_init(&actions);
        posix_spawn_file_actions_adddup2(&actions, childIn.get(), STDIN_FILENO);
        posix_spawn_file_actions_adddup2(&actions, childOut.get(), STDOUT_FILENO);
        std::string limit = std::to_string(megabytes);
        std::string time = std::to_string(static_cast<int>(std::ceil(processorSeconds)));
        std::array<char*, 4> arguments{const_cast<char*>(path.c_str()), limit.data(),
                                       processorSeconds > 0 ? time.data() : nullptr, nullptr};
        const Attributes attributes;
        const int error =
            posix_spawn(&m_pid, path.c_str(), &actions, attributes.get(), arguments.data(), environ);
        posix_spawn_file_actions_destroy(&actions);
        fcntl(m_in.get(), F_SETFL, O_NONBLOCK);
        return error == 0;
    }

    /// Feeds and reads for up to 50 ms; false when the child has closed its output.
    bool exchange(const std::string& input, std::size_t& sent, std::string& output) {
        std::array<pollfd, 2> waits{pollfd{m_out.get(), POLLIN, 0}, pollfd{m_in.get(), POLLOUT, 0}};
        poll(waits.data(), m_in.get() >= 0 ? 2 : 1, 50);
        if (m_in.get() >= 0 && waits[1].revents != 0) feed(input, sent);
        if ((waits[0].revents & (POLLIN | POLLHUP)) == 0) return true;
        std::array<char, 65536> buffer;
        const ssize_t got = read(m_out.get(), buffer.data(), buffer.size());
        if (got > 0) output.append(buffer.data(), static_cast<std::size_t>(got));
        return got > 0 || (got < 0 && errno == EINTR);
    }

    /// Kills the child's process group, which contains everything that it started.
    void kill() const {
        ::kill(-m_pid, SIGKILL);
        ::kill(m_pid, SIGKILL);
    }
    pid_t id() const { return m_pid; }

    int wait() const {
        int status = 0;
        while (waitpid(m_pid, &status, 0) < 0 && errno == EINTR) continue;
        return status;
    }

  private:
    void feed(const std::string& input, std::size_t& sent) {
        const ssize_t wrote = write(m_in.get(), input.data() + sent, input.size() - sent);
        if (wrote > 0) sent += static_cast<std::size_t>(wrote);
        if (sent == input.size() || (wrote < 0 && errno != EAGAIN && errno != EINTR)) m_in.reset();
    }

    pid_t m_pid = 0;
    Descriptor m_in, m_out;
};

/// The CPU time of a process group, and whether one of its processes is runnable or waits for the disk.
struct Pulse {
    unsigned long ticks = 0;
    bool awake = false;
};

/// Returns the CPU time that all processes of a group have used, and whether one of them is running or waits
/// for a disk, from /proc.
Pulse pulseOf(pid_t wanted) {
    Pulse pulse;
    std::error_code error;
    for (const auto& entry : std::filesystem::directory_iterator("/proc", error)) {
        std::ifstream file(entry.path() / "stat");
        std::string line;
        if (!std::getline(file, line)) continue;
        // "(name) state parent group …"; user and system time are the 9th and 10th after the group.
        std::istringstream fields(line.substr(std::min(line.rfind(')') + 1, line.size())));
        char state = 0;
        pid_t parent = 0, group = 0;
        fields >> state >> parent >> group;
        if (group != wanted) continue;
        std::string skipped;
        for (int k = 0; k < 8; ++k) fields >> skipped;
        unsigned long user = 0, system = 0;
        fields >> user >> system;
        pulse.ticks += user + system;
        pulse.awake = pulse.awake || state == 'R' || state == 'D';
    }
    return pulse;
}

}  // namespace

/// Compares output and CPU time with those of the last look. A process that is running or waits for a disk is
/// not idle.
bool IdleWatch::isIdle(std::size_t said) {
    const auto now = Clock::now();
    if (m_seconds <= 0 || now < m_next) return false;
    m_next = now + std::chrono::milliseconds(200);
    const Pulse pulse = pulseOf(m_group);
    const std::pair state(pulse.ticks, said);
    if (state != m_state || pulse.awake) m_since = now;
    m_state = state;
    return std::chrono::duration<double>(now - m_since).count() > m_seconds;
}

/// Feeds the input and collects the output until the child ends, is idle, times out or is stopped; then its
/// process group is killed.
ChildResult runChild(const std::string& path, const std::string& input, double seconds, int megabytes,
                     const std::stop_token& stop, double processorSeconds, double idleSeconds) {
    const IgnoreBrokenPipe guard;
    ChildResult result;
    Child child;
    if (!child.start(path, megabytes, processorSeconds)) return {ChildResult::End::NotStarted, errno, {}};
    IdleWatch watch(child.id(), idleSeconds);
    const auto end = Clock::now() + std::chrono::duration<double>(seconds);
    std::size_t sent = 0;
    auto reason = ChildResult::End::Exited;
    while (child.exchange(input, sent, result.output)) {
        if (stop.stop_requested())
            reason = ChildResult::End::Stopped;
        else if (Clock::now() > end)
            reason = ChildResult::End::TimedOut;
        else if (watch.isIdle(result.output.size()))
            reason = ChildResult::End::Idle;
        if (reason == ChildResult::End::Exited) continue;
        child.kill();
        break;
    }
    const int status = child.wait();
    result.end = reason;
    if (reason == ChildResult::End::Exited && WIFSIGNALED(status)) result.end = ChildResult::End::Signalled;
    if (result.end == ChildResult::End::Signalled && WTERMSIG(status) == SIGXCPU)
        result.end = ChildResult::End::TimedOut;
    result.code = WIFSIGNALED(status) ? WTERMSIG(status) : WEXITSTATUS(status);
    return result;
}

/// Looks beside the program, in the folders of an installation, and, for a library in another program, near
/// the library.
std::string siblingProgram(const std::string& name) {
    std::error_code error;
    const auto program = std::filesystem::read_symlink("/proc/self/exe", error).parent_path();
    const auto installed = program / ".." / "lib" / "wend" / name;
    std::vector<std::filesystem::path> places{program / name, installed};
    Dl_info own{};  // of the library that contains this function, or the program itself
    // The name of a program may be relative to a folder that has changed since.
    if (dladdr(reinterpret_cast<const void*>(&siblingProgram), &own) != 0 && own.dli_fname &&
        own.dli_fname[0] == '/') {
        const auto library = std::filesystem::path(own.dli_fname).parent_path();
        // The places are for a library in lib, in lib/TRIPLE, and as a module of Python in
        // lib/python3/dist-packages.
        for (const char* way : {".", "wend", "../wend", "../../wend"}) places.push_back(library / way / name);
    }
    const auto found = std::ranges::find_if(places, [&](const std::filesystem::path& place) {
        return std::filesystem::is_regular_file(place, error);
    });
    return (found != places.end() ? *found : installed).string();
}

}  // namespace wend
