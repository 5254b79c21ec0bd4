#pragma once

#include <chrono>
#include <functional>
#include <stop_token>
#include <thread>

namespace wend {

/// Turns Ctrl-C (SIGINT) and SIGTERM into a stop request while it lives: work ends at the next good place and
/// leaves nothing half-written. Work that has not ended after a while, as within a library that cannot be
/// stopped, ends with the process, which leaves nothing half-written either. The third signal ends the
/// process at once. One at a time.
class Interrupt {
  public:
    /// `sayCancelled` is called, from another thread, before the process ends, `patience` after the signal.
    explicit Interrupt(std::function<void()> sayCancelled,
                       std::chrono::milliseconds patience = std::chrono::milliseconds(200));
    ~Interrupt();
    Interrupt(const Interrupt&) = delete;
    Interrupt& operator=(const Interrupt&) = delete;

    std::stop_token token() const { return m_source.get_token(); }

  private:
    void wait();

    std::function<void()> m_sayCancelled;
    std::chrono::milliseconds m_patience;
    std::stop_source m_source;
    int m_pipe[2] = {-1, -1};
    std::thread m_waiter;
};

}  // namespace wend
