#pragma once

#include "bench/recorder.h"

namespace wend {

struct PaperOptions {
    int flatVertices = 5600, solidVertices = 1500;  // of the deformed shapes: the paper's smaller ones
    bool timings = true;                            // of the paper's sizes
    std::string folder;  // where meshes, projects and deformed shapes stay; empty: nowhere
};

/// Adds the paper's figures on shapes of our own: each scene as a case with a row for each material, by the
/// code of `wend run`, and the paper's timing table. Returns what the paper finds and whether it holds.
std::vector<BenchClaim> addPaperCases(const PaperOptions& options, BenchRecorder& recorder);

}  // namespace wend
