#pragma once

#include <string>
#include <utility>
#include <vector>

#include "bench/measure.h"

namespace wend {

/// One thing that was measured, with whatever figures belong to it beside the time: ("iterations", 3) …
struct BenchRow {
    std::string what;
    int threads = 1;  // 0: all cores
    Timing time;
    std::vector<std::pair<std::string, double>> figures;
};

/// The rows of one shape.
struct BenchCase {
    std::string name;
    int dimension = 0, vertices = 0, cells = 0;
    std::vector<BenchRow> rows;
};

/// Something that is to hold of figures, and what they are.
struct BenchClaim {
    std::string what;
    bool holds = true;
    std::vector<std::pair<std::string, double>> values;
};

struct BenchTable {
    std::string machine;
    std::string simd;  // the target of its kernels: "avx2"
    int cores = 0;
    std::vector<BenchCase> cases;
    std::vector<BenchClaim> claims;
};

/// How the time of a row grows with the number of vertices, over the cases of one dimension.
struct Growth {
    int dimension;
    std::string what;
    int threads;
    double exponent;
};
std::vector<Growth> growthOf(const BenchTable& table);

/// Returns a row as people read it: "assembly, cpu, 1 thread        0.412 ms   …".
std::string textOf(const BenchRow& row);
std::string headingOf(const BenchCase& one);
/// Returns for example "holds: EQUIA keeps …: volume: strip/EQUIA 0.0001 < …".
std::string textOf(const BenchClaim& claim);
std::string textOf(const std::vector<Growth>& growth);
/// Returns the whole table for programs, with seconds as numbers.
std::string jsonOf(const BenchTable& table);

/// Returns the processor's name as the system gives it; empty if it gives none.
std::string processorName();

}  // namespace wend
