#include "core/base/fed_process.h"

#include <poll.h>
#include <sys/wait.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <sstream>

#include "core/base/error.h"

extern char** environ;

namespace wend {
namespace {

constexpr std::size_t kMostOutput = 16384;  // bytes that are kept; the rest is read and dropped

std::vector<char*> pointersTo(std::vector<std::string>& words) {
    std::vector<char*> pointers;
    for (std::string& word : words) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    return pointers;
}

}  // namespace

/// Starts the program in a process group of its own. If that fails, output() says why, and feed() returns
/// false.
FedProcess::FedProcess(const std::string& program, const std::vector<std::string>& arguments) {
    Descriptor childIn, childOut;
    if (!makePipe(childIn, m_in) || !makePipe(m_out, childOut)) {
        m_output = std::strerror(errno);
        return;
    }
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, childIn.get(), STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&actions, childOut.get(), STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions, childOut.get(), STDERR_FILENO);
    std::vector<std::string> words{program};
    words.insert(words.end(), arguments.begin(), arguments.end());
    const Attributes attributes;
    const int error =
        posix_spawn(&m_pid, program.c_str(), &actions, attributes.get(), pointersTo(words).data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    fcntl(m_in.get(), F_SETFL, O_NONBLOCK);
    if (error == 0) return;
    m_pid = 0;
    m_in.reset(), m_out.reset();
    m_output = std::strerror(error);
}

FedProcess::~FedProcess() {
    if (m_pid == 0) return;
    ::kill(-m_pid, SIGKILL);
    ::kill(m_pid, SIGKILL);
    wait();
}

void FedProcess::read() {
    std::array<char, 4096> buffer;
    const ssize_t got = ::read(m_out.get(), buffer.data(), buffer.size());
    if (got > 0 && m_output.size() < kMostOutput) m_output.append(buffer.data(), std::size_t(got));
    if (got == 0 || (got < 0 && errno != EINTR)) m_out.reset();
}

/// Writes and reads for up to 50 ms.
void FedProcess::exchange() {
    std::array<pollfd, 2> waits{pollfd{m_out.get(), POLLIN, 0}, pollfd{m_in.get(), POLLOUT, 0}};
    poll(waits.data(), waits.size(), 50);  // a closed end, -1, is left out
    if (waits[0].revents != 0) read();
    if (waits[1].revents == 0) return;
    const ssize_t wrote = write(m_in.get(), m_left.data(), m_left.size());
    if (wrote > 0) m_left = m_left.subspan(static_cast<std::size_t>(wrote));
    if (wrote < 0 && errno != EAGAIN && errno != EINTR) m_in.reset();
}

bool FedProcess::feed(std::span<const std::byte> bytes, const std::stop_token& stop) {
    const IgnoreBrokenPipe guard;
    m_left = bytes;
    while (m_in.get() >= 0 && !m_left.empty()) {
        if (stop.stop_requested()) throw Cancelled();
        exchange();
    }
    return m_in.get() >= 0;
}

bool FedProcess::finish(const std::stop_token& stop) {
    if (m_pid == 0) return false;
    m_in.reset();
    while (m_out.get() >= 0) {
        if (stop.stop_requested()) throw Cancelled();
        exchange();
    }
    const int status = wait();
    if (WIFSIGNALED(status) && m_output.empty())
        m_output = WTERMSIG(status) == SIGXFSZ ? std::strerror(EFBIG)
                                               : "ended by signal " + std::to_string(WTERMSIG(status));
    return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

int FedProcess::wait() {
    int status = 0;
    while (waitpid(m_pid, &status, 0) < 0 && errno == EINTR) continue;
    m_pid = 0;
    return status;
}

std::string programInPath(const std::string& name) {
    const char* variable = std::getenv("PATH");
    std::istringstream folders(variable ? variable : "");
    for (std::string folder; std::getline(folders, folder, ':');) {
        std::error_code error;
        const std::filesystem::path file = std::filesystem::path(folder) / name;
        if (file.is_absolute() && std::filesystem::is_regular_file(file, error) &&
            access(file.c_str(), X_OK) == 0)
            return file.string();
    }
    return {};
}

}  // namespace wend
