#pragma once

#include <functional>
#include <stop_token>
#include <string>
#include <vector>

#include "bench/table.h"

namespace wend {

struct BenchOptions {
    std::vector<std::string> cases;  // of benchCases(); empty: all but "paper"
    std::string folder;              // where the case "paper" keeps its files; empty: nowhere
    int repeats = 5;
    std::function<void(const std::string& line)> say;  // each result as soon as it is available
    std::stop_token stop;
};

/// Returns the names of the cases: "2d-5.6k", …, "3d-20k", "warp", "kernels", "paper".
std::vector<std::string> benchCases();

/// Runs the measurements. Ratios are between rows of one case, taken in this one process. Throws InputError
/// for a case that there is not, and Cancelled.
BenchTable runBenchmarks(const BenchOptions& options);

}  // namespace wend
