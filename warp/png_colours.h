#pragma once

#include <optional>
#include <string>

#include "core/base/input_file.h"
#include "warp/colour_space.h"

namespace wend {

/// The contents of a sound PNG file (pngProblem()) that its library does not report.
struct PngExtras {
    std::optional<ColourSpace>
        colours;                 // by cICP, or by cHRM and gAMA; nothing for sRGB and beside a profile
    std::string unknownColours;  // the four numbers of a cICP chunk that is not understood
    unsigned frames = 1;         // of an animation
    bool hasProfile = false;     // and no cICP that takes its place
};
PngExtras pngExtras(const InputFile& file);

}  // namespace wend
