#pragma once

#include <stop_token>
#include <thread>

namespace wend {

/// Turns Ctrl-C (SIGINT) and SIGTERM into a stop request while it lives: work ends at the next good place and
/// leaves nothing half-written. The third one ends the process at once. One at a time.
class Interrupt {
  public:
    Interrupt();
    ~Interrupt();
    Interrupt(const Interrupt&) = delete;
    Interrupt& operator=(const Interrupt&) = delete;

    std::stop_token token() const { return m_source.get_token(); }

  private:
    std::stop_source m_source;
    int m_pipe[2] = {-1, -1};
    std::thread m_waiter;
};

}  // namespace wend
