#pragma once

#include "app/document/project.h"

namespace wend {

/// A picture's project with an outline of the user's own, without the points of pins that lie beside it (and
/// pins that have none left).
struct OutlineEdit {
    Project project;
    int pinsGone = 0;
};
OutlineEdit withOutline(const Project& project, Outline outline);

}  // namespace wend
