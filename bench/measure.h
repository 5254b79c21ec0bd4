#pragma once

#include <functional>
#include <vector>

namespace wend {

/// Seconds of a piece of work over several runs: the clock on the wall, and the processors' time of all
/// threads, which other programs on the machine disturb less.
struct Timing {
    double median = 0, minimum = 0, maximum = 0;
    double processor = 0;  // the median
    int repeats = 0;
};

/// Runs the work once to warm up and then as often as asked, each time after `prepare`, which does not count.
Timing measure(int repeats, const std::function<void()>& work, const std::function<void()>& prepare = {});
/// Runs the work once, without a warm-up, for work that takes many seconds.
Timing measureOnce(const std::function<void()>& work);

/// Returns the bytes per second that one thread reads of a block of this size that it has just read before.
/// They bound a triangular solve, which reads every entry of the factor once forward and once backward.
double readBandwidth(double bytes);

/// Returns the exponent p of the least-squares fit t = c nᵖ; 0 with fewer than two points.
double growthExponent(const std::vector<double>& n, const std::vector<double>& t);

}  // namespace wend
