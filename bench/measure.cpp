#include "bench/measure.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <vector>

namespace wend {
namespace {

struct Reading {
    double wall, processor;
};

Reading clocks() {
    timespec processor{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &processor);
    const auto wall = std::chrono::steady_clock::now().time_since_epoch();
    return {std::chrono::duration<double>(wall).count(),
            static_cast<double>(processor.tv_sec) + 1e-9 * static_cast<double>(processor.tv_nsec)};
}

Reading timed(const std::function<void()>& work) {
    const Reading start = clocks();
    work();
    const Reading end = clocks();
    return {end.wall - start.wall, end.processor - start.processor};
}

double middle(std::vector<double>& values) {
    const auto half = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), half, values.end());
    return *half;
}

}  // namespace

Timing measure(int repeats, const std::function<void()>& work, const std::function<void()>& prepare) {
    std::vector<double> walls, processors;
    for (int i = 0; i <= repeats; ++i) {
        if (prepare) prepare();
        const Reading one = timed(work);
        if (i == 0) continue;
        walls.push_back(one.wall);
        processors.push_back(one.processor);
    }
    const auto [minimum, maximum] = std::minmax_element(walls.begin(), walls.end());
    Timing timing{0, *minimum, *maximum, middle(processors), repeats};
    timing.median = middle(walls);
    return timing;
}

Timing measureOnce(const std::function<void()>& work) {
    const Reading one = timed(work);
    return {one.wall, one.wall, one.wall, one.processor, 1};
}

double readBandwidth(double bytes) {
    const std::vector<double> block(static_cast<std::size_t>(std::max(bytes, 4096.0) / sizeof(double)), 1.0);
    volatile double sink = 0;
    const Timing timing = measure(5, [&] {
        double sums[8] = {};  // independent, so that memory is the limit and not the chain of additions
        for (std::size_t i = 0; i + 8 <= block.size(); i += 8)
            for (std::size_t k = 0; k < 8; ++k) sums[k] += block[i + k];
        sink = sums[0] + sums[1] + sums[2] + sums[3] + sums[4] + sums[5] + sums[6] + sums[7];
    });
    return static_cast<double>(block.size() * sizeof(double)) / timing.minimum;
}

double growthExponent(const std::vector<double>& n, const std::vector<double>& t) {
    if (n.size() < 2) return 0;
    double meanX = 0, meanY = 0, xx = 0, xy = 0;
    for (std::size_t i = 0; i < n.size(); ++i) {
        meanX += std::log(n[i]) / static_cast<double>(n.size());
        meanY += std::log(t[i]) / static_cast<double>(n.size());
    }
    for (std::size_t i = 0; i < n.size(); ++i) {
        xx += (std::log(n[i]) - meanX) * (std::log(n[i]) - meanX);
        xy += (std::log(n[i]) - meanX) * (std::log(t[i]) - meanY);
    }
    return xx > 0 ? xy / xx : 0;
}

}  // namespace wend
