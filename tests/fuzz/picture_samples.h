#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace wend::fuzz {

struct Sample {
    std::string name, bytes;
    /// What the reader says of the whole file behind its path, where one of its layers is of a kind that
    /// cannot be read.
    std::string refusal = {};
};

/// Small sound pictures of every format that is read, in the layouts that each has: channels, depths,
/// compressions, tiles, palettes. What OpenImageIO cannot write is put together byte by byte. `folder` is for
/// files on the way.
std::vector<Sample> makeSamples(const std::filesystem::path& folder);

}  // namespace wend::fuzz
