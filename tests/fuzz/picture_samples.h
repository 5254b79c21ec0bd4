#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace wend::fuzz {

struct Sample {
    std::string name, bytes;
};

/// Small sound pictures of every format that is read, in the layouts that each has: channels, depths,
/// compressions, tiles, palettes. What OpenImageIO cannot write is put together byte by byte. `folder` is for
/// files on the way.
std::vector<Sample> makeSamples(const std::filesystem::path& folder);

}  // namespace wend::fuzz
