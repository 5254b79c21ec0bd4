#include "core/integration/settling.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace wend {
namespace {

constexpr double kDecay = 30;  // of small deviations over a window, as an exponent

bool within(const SettleWindow& window, double t, Side side) {
    return side == Side::After ? window.start <= t && t < window.end : window.start < t && t <= window.end;
}

}  // namespace

/// Checks each window, and that it does not begin before the end of the one before it.
std::string problemOf(const std::vector<SettleWindow>& windows) {
    for (std::size_t i = 0; i < windows.size(); ++i) {
        const std::string name = "settle window " + std::to_string(i + 1);
        if (!(std::isfinite(windows[i].start) && std::isfinite(windows[i].end)))
            return name + " has an end that is not a finite number";
        if (!(windows[i].start < windows[i].end)) return name + " is reversed or empty";
        if (windows[i].start < 0) return name + " begins before time 0";
        if (i > 0 && windows[i].start < windows[i - 1].end)
            return name + " begins before window " + std::to_string(i) + " has ended";
    }
    return {};
}

double Settling::rate(double t, Side side) const {
    for (const SettleWindow& window : m_windows)
        if (within(window, t, side)) return kDecay / (window.end - window.start);
    return 0;
}

double Settling::nextBreakpoint(double t) const {
    double next = std::numeric_limits<double>::infinity();
    for (const SettleWindow& window : m_windows)
        for (const double end : {window.start, window.end})
            if (end > t) next = std::min(next, end);
    return next;
}

double Settling::lastBreakpoint(double t) const {
    double last = -std::numeric_limits<double>::infinity();
    for (const SettleWindow& window : m_windows)
        for (const double end : {window.start, window.end})
            if (end <= t) last = std::max(last, end);
    return last;
}

}  // namespace wend
