#pragma once

#include <vector>

#include "core/integration/integration_options.h"
#include "core/motion/trajectory.h"

namespace wend {

/// Knows the intervals in which the shape settles, and how fast.
class Settling {
  public:
    Settling() = default;
    explicit Settling(std::vector<SettleWindow> windows) : m_windows(std::move(windows)) {}

    /// Returns the rate at which the gradient is followed: 30 / (t1 − t0) inside an interval, so that e⁻³⁰ of
    /// a small deviation remains at its end; 0 outside. At an end of a window the side decides.
    double rate(double t, Side side) const;
    /// Return the first end of a window after t, or +infinity, and the last one up to t, or −infinity.
    double nextBreakpoint(double t) const;
    double lastBreakpoint(double t) const;

  private:
    std::vector<SettleWindow> m_windows;
};

}  // namespace wend
