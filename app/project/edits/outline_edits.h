#pragma once

#include <memory>

#include "app/project/project_fwd.h"
#include "core/meshing/outline.h"

namespace wend {

/// Sets the user's outline of a picture. Removes points of pins outside it, and pins without points. Returns
/// the number of removed pins.
int setOutline(Project& project, Outline outline);

/// Returns a project in which a part of the picture has that outline, with the number of removed pins: those
/// that name the part.
std::shared_ptr<const Project> withDrawnOutline(const Project& project, int part, Outline outline,
                                                int& pinsGone);

}  // namespace wend
