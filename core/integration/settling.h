#pragma once

#include <string>
#include <vector>

#include "core/motion/trajectory.h"

namespace wend {

/// A window of time in which the shape settles: it flows towards least energy of its map from rest, with the
/// handles as they are (method.md, Memory and settling).
struct SettleWindow {
    double start = 0, end = 1;
    bool operator==(const SettleWindow&) const = default;
};

/// Empty if the windows are finite, in the order of time and apart from each other, else the reason.
std::string problemOf(const std::vector<SettleWindow>& windows);

/// The settling in time.
class Settling {
  public:
    Settling() = default;
    explicit Settling(std::vector<SettleWindow> windows) : m_windows(std::move(windows)) {}

    /// How fast the gradient is followed: 30 / (t1 − t0) inside a window, so that e⁻³⁰ of a small deviation
    /// is left at its end; 0 outside.
    double rate(double t, Side side) const;
    /// The first end of a window after t, or +infinity; the last one up to t, or −infinity.
    double nextBreakpoint(double t) const;
    double lastBreakpoint(double t) const;

  private:
    std::vector<SettleWindow> m_windows;
};

}  // namespace wend
