#include "app/cli/interrupt.h"

#include <poll.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <stdexcept>

#include "app/cli/cli.h"
#include "core/base/input_file.h"
#include "core/base/last_act.h"
#include "core/base/safe_file.h"

namespace wend {
namespace {

// A signal handler reaches nothing but globals, and may do little more than write to a pipe.
std::atomic<int> interruptPipe = -1;
std::atomic<int> interruptCount = 0;

extern "C" void onInterrupt(int) {
    if (++interruptCount >= 3) endProcess(1);
    stopReading(true);
    const char signalled = 's';
    if (write(interruptPipe, &signalled, 1) < 0) endProcess(1);
}

}  // namespace

Interrupt::Interrupt(std::function<void()> sayCancelled, std::chrono::milliseconds patience)
    : m_sayCancelled(std::move(sayCancelled)), m_patience(patience) {
    if (pipe(m_pipe) != 0) throw std::runtime_error("no pipe could be opened");
    interruptPipe = m_pipe[1];
    m_waiter = std::thread([this] { wait(); });
    std::signal(SIGINT, onInterrupt);
    std::signal(SIGTERM, onInterrupt);
}

/// Waits until this object is destroyed, or until the end of the process.
void Interrupt::wait() {
    const auto next = [this] {
        char why = 0;
        return read(m_pipe[0], &why, 1) == 1 ? why : 'e';
    };
    char why = next();
    while (why == 's') {
        m_source.request_stop();
        pollfd signal{m_pipe[0], POLLIN, 0};
        const bool late = poll(&signal, 1, static_cast<int>(m_patience.count())) == 0;
        if (late && abandonPendingFiles()) {
            m_sayCancelled();
            endProcess(static_cast<int>(ExitCode::Incomplete));
        }
        why = next();
    }
}

Interrupt::~Interrupt() {
    std::signal(SIGINT, SIG_DFL);
    std::signal(SIGTERM, SIG_DFL);
    stopReading(false);
    const char ended = 'e';
    if (write(m_pipe[1], &ended, 1) == 1) m_waiter.join();
    close(m_pipe[0]);
    close(m_pipe[1]);
}

}  // namespace wend
