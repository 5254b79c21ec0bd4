#pragma once

#include <functional>
#include <stop_token>
#include <thread>

namespace wend {

/// Turns Ctrl-C (SIGINT) and SIGTERM into a stop request while it lives: work ends at the next good place and
/// leaves nothing half-written. Work that has not ended a third of a second later, as within a library that
/// cannot be stopped, ends with the process, which leaves nothing half-written either. The third signal ends
/// the process at once. One at a time.
class Interrupt {
  public:
    /// `sayCancelled` is called, from another thread, before the process ends.
    explicit Interrupt(std::function<void()> sayCancelled);
    ~Interrupt();
    Interrupt(const Interrupt&) = delete;
    Interrupt& operator=(const Interrupt&) = delete;

    std::stop_token token() const { return m_source.get_token(); }

  private:
    void wait();

    std::function<void()> m_sayCancelled;
    std::stop_source m_source;
    int m_pipe[2] = {-1, -1};
    std::thread m_waiter;
};

}  // namespace wend
