#pragma once

#include "app/document/project_fwd.h"
#include "core/meshing/outline.h"

namespace wend {

/// Sets the user's outline of a picture. Removes points of pins outside it, and pins without points. Returns
/// the number of removed pins.
int setOutline(Project& project, Outline outline);

}  // namespace wend
