#include "app/cli/interrupt.h"

#include <unistd.h>

#include <atomic>
#include <csignal>
#include <stdexcept>

#include "core/mesh/input_file.h"

namespace wend {
namespace {

// A signal handler reaches nothing but globals, and may do little more than write to a pipe.
std::atomic<int> interruptPipe = -1;
std::atomic<int> interruptCount = 0;

extern "C" void onInterrupt(int) {
    if (++interruptCount >= 3) _exit(1);
    stopReading(true);
    const char signalled = 's';
    if (write(interruptPipe, &signalled, 1) < 0) _exit(1);
}

}  // namespace

Interrupt::Interrupt() {
    if (pipe(m_pipe) != 0) throw std::runtime_error("no pipe could be opened");
    interruptPipe = m_pipe[1];
    m_waiter = std::thread([this] {
        char why = 0;
        while (read(m_pipe[0], &why, 1) == 1 && why == 's') m_source.request_stop();
    });
    std::signal(SIGINT, onInterrupt);
    std::signal(SIGTERM, onInterrupt);
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
