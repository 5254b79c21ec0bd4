#pragma once

#include <array>
#include <optional>
#include <string>

#include "app/project/project_fwd.h"
#include "core/base/message.h"
#include "warp/vector_drawing.h"

namespace wend {

struct Domain;

/// Scales all coordinates and lengths of a picture's project by `factor`: pins, paths, regions and outlines.
void scalePixels(Project& project, double factor);

/// Returns the factor from a picture's size to another one of the same proportions, up to a pixel; 0 if the
/// proportions differ.
double factorBetween(const std::array<int, 2>& from, const std::array<int, 2>& to);

/// Scales a project that was made for a picture of another size (domain.size) to the one that its file has
/// now. Returns a notice if the sizes differ, else an empty one. A picture that cannot be read is ignored.
Message fitToPicture(Project& project, const std::string& folder);

/// Returns the path of the first SVG drawing among the pictures of a project; empty if there is none.
std::string drawingIn(const Domain& domain, const std::string& folder);

/// Returns the size in pixels that a text asks for, in the proportions of a drawing that has `now`: "2000"
/// (its width), "2000x1500" (as large as fits into that) or "150%"; nothing for anything else.
std::optional<DrawnSize> drawnSizeOf(const std::string& text, const DrawnSize& now);

/// Returns the size at which the drawings of a picture are drawn. Throws InputError that names the file.
DrawnSize drawnSize(const Domain& domain, const std::string& folder);

/// Draws the pictures of a project in another size; pins, paths and regions are scaled with them.
void drawAt(Project& project, const DrawnSize& before, const DrawnSize& now);

}  // namespace wend
