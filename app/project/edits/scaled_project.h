#pragma once

#include <array>
#include <string>

#include "app/project/project_fwd.h"
#include "core/base/message.h"

namespace wend {

/// Scales all coordinates and lengths of a picture's project by `factor`: pins, paths, regions and outlines.
void scalePixels(Project& project, double factor);

/// Returns the factor from a picture's size to another one of the same proportions, up to a pixel; 0 if the
/// proportions differ.
double factorBetween(const std::array<int, 2>& from, const std::array<int, 2>& to);

/// Scales a project that was made for a picture of another size (domain.size) to the one that its file has
/// now. Returns a notice if the sizes differ, else an empty one. A picture that cannot be read is ignored.
Message fitToPicture(Project& project, const std::string& folder);

}  // namespace wend
