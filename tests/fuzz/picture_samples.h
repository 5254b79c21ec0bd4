#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace wend::fuzz {

struct Sample {
    std::string name, bytes;
    /// The reader's message after the path, if one of the layers is of an unsupported kind.
    std::string refusal = {};
};

/// Returns small valid pictures of every supported format, in the layouts that each has: channels, depths,
/// compressions, tiles, palettes. Those that OpenImageIO cannot write are put together byte by byte. `folder`
/// is for temporary files.
std::vector<Sample> makeSamples(const std::filesystem::path& folder);

}  // namespace wend::fuzz
