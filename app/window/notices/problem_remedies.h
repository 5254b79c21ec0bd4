#pragma once

#include "app/window/notices/info_banner.h"

namespace wend {

class ShapeSession;

/// Returns buttons for a project that cannot be computed: where memory is short, a solver that needs less and
/// half as many vertices, as far as the project allows; and Undo if there is a step.
QList<InfoBanner::Remedy> problemRemedies(ShapeSession& session);

}  // namespace wend
