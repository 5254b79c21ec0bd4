#pragma once

#include <string>

#include "app/cli/arguments.h"
#include "app/project/project_fwd.h"
#include "warp/vector_drawing.h"

namespace wend {

/// Draws the drawings of a project in the size that --size asks for, if it is given. Throws UsageError, and
/// InputError if there is no drawing.
void drawInSize(const Arguments& arguments, const std::string& folder, Project& project);

/// Returns the size of a file's drawing that --size asks for; zeros without. Throws the same.
DrawnSize sizeOfDrawing(const Arguments& arguments, const std::string& path);

}  // namespace wend
