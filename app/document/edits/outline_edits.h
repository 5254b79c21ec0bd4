#pragma once

#include "app/document/project_fwd.h"
#include "core/meshing/outline.h"

namespace wend {

/// Gives a picture's project an outline of the user's own and takes away the points of pins that lie beside
/// it, and pins that have none left: so many.
int setOutline(Project& project, Outline outline);

}  // namespace wend
